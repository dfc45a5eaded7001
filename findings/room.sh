# Sourced by the scripts of this folder: a room, which is a temporary folder with outside packages of stated
# versions. Nothing is installed, and the room goes when the script ends. FINDINGS_KEEP names a folder that
# keeps the downloads for the next script.

set -eu
room=$(mktemp -d)
trap 'rm -rf "$room"' EXIT
keep=${FINDINGS_KEEP:-$room/kept}
mkdir -p "$keep/debian/partial" "$keep/npm" "$room/usr"

# debian NAME=VERSION ...: these packages and what they need, unpacked into the room. What the machine has in
# that version already is used as it is.
debian() {
  here=yes
  for package; do
    [ "$(dpkg-query --show --showformat='${Version}' "${package%%=*}" 2>"$room/dpkg.log")" = "${package#*=}" ] || here=no
  done
  [ $here = no ] || return 0
  apt-get install --yes --quiet=2 --no-install-recommends --download-only --allow-downgrades \
    -o Debug::NoLocking=1 -o Dir::Cache::archives="$keep/debian" "$@" >"$room/apt.log" 2>&1 || {
    cat "$room/apt.log" >&2
    exit 1
  }
  apt-get install --quiet=2 --no-install-recommends --allow-downgrades --simulate "$@" |
    sed -n 's/^Inst \([^ ]*\) .*(\([^ ]*\) .* \[\(.*\)\]).*/\1 \2 \3/p' | while read -r name version kind; do
    file=$keep/debian/${name%%:*}_$(printf %s "$version" | sed 's/:/%3a/g')_$kind.deb
    dpkg -x "$file" "$room"
  done
}

# npm_packages NAME@VERSION ...: these npm packages in $room/node_modules.
npm_packages() {
  npm install --prefix "$room" --cache "$keep/npm" --prefer-offline --ignore-scripts --no-audit --no-fund \
    --loglevel=error "$@" >"$room/npm.log" 2>&1 || {
    cat "$room/npm.log" >&2
    exit 1
  }
}

# node_of VERSION: the Node.js of that version, as $node.
node_of() {
  case $(uname -m) in aarch64) kind=arm64 ;; *) kind=x64 ;; esac
  npm_packages "node-linux-$kind@$1"
  node=$room/node_modules/node-linux-$kind/bin/node
}

# in_room COMMAND ...: runs it with the room's files laid over /usr, as though its packages were installed.
in_room() {
  own=
  [ "$(id -u)" = 0 ] || own=--map-root-user
  unshare $own --mount sh -c '
    mount -t overlay overlay -o "lowerdir=$0/usr:/usr" /usr && cd "$0"
    LD_LIBRARY_PATH=/usr/lib/$(uname -m)-linux-gnu/blas:/usr/lib/$(uname -m)-linux-gnu/lapack
    export LD_LIBRARY_PATH
    exec "$@"' "$room" "$@"
}

# as_seen FILE: compares FILE with what the head of the script says was seen: its lines "#> ...".
as_seen() {
  sed -n 's/^#> \{0,1\}//p' "$0" >"$room/said"
  if diff -u "$room/said" "$1"; then
    cat "$1"
  else
    echo "$(basename "$0"): what is seen has changed" >&2
    exit 1
  fi
}
