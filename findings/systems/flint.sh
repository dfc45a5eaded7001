#!/bin/sh
# Arb (now part of FLINT) at 53 and at 170 bits, asked for the pendulum near the top: every answer comes with a
# radius, shown where there is no number. Seen: book/systems/flint.json.
. "$(dirname "$0")/question.sh"
debian libflint-arb-dev=1:2.23.0-1+b1
cat >"$room/asked" <<'ASKED'
system Arb
version 2.23.0
from Debian libflint-arb-dev 1:2.23.0-1+b1
K.call acb_elliptic_k(K, m, bits)
Pi.call acb_elliptic_pi(Pi, n, m, bits)
T.1 2/π · acb_elliptic_k of cos²(eta/2), 53 bits
T.2 the same, 170 bits
ASKED
cat >"$room/ask.c" <<'C'
#include <acb_elliptic.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static void say(const acb_t z)
{
  if(!acb_is_finite(z)) printf(" nan");
  else printf(" %.17g", arf_get_d(arb_midref(acb_realref(z)), ARF_RND_NEAR));
}

static void period(double eta, slong bits)
{
  acb_t m;
  arb_t pi;
  acb_init(m);
  arb_init(pi);
  acb_set_d(m, eta / 2);
  acb_cos(m, m, bits);
  acb_sqr(m, m, bits);
  acb_elliptic_k(m, m, bits);
  arb_const_pi(pi, bits);
  acb_mul_2exp_si(m, m, 1);
  acb_div_arb(m, m, pi, bits);
  say(m);
}

int main(int argc, char** argv)
{
  acb_t z, n;
  acb_init(z);
  acb_init(n);
  acb_set_d(n, 0.25);
  printf("K.quarter");
  acb_elliptic_k(z, n, 53);
  say(z);
  printf("\nK.one");
  acb_set_d(z, 1);
  acb_elliptic_k(z, z, 53);
  say(z);
  acb_set_d(z, 1.5);
  acb_elliptic_k(z, z, 53);
  printf("\nK.beyond %.17g - %.17gi", arf_get_d(arb_midref(acb_realref(z)), ARF_RND_NEAR),
         -arf_get_d(arb_midref(acb_imagref(z)), ARF_RND_NEAR));
  printf("\nPi.quarter");
  acb_elliptic_pi(z, n, n, 53);
  say(z);
  printf("\nT.1");
  for(int i = 1; i < argc; ++i) period(atof(argv[i]), 53);
  printf("\nT.2");
  for(int i = 1; i < argc; ++i) period(atof(argv[i]), 170);
  puts("");
  return 0;
}
C
in_room cc -w ask.c -o ask -lflint-arb -lflint -lm
in_room ./ask $eta >"$room/said"
as_recorded flint
