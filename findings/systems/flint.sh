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
Phi.1 2 atan(θ₂ θ₁(z)/(θ₄ θ₃(z))) by acb_modular_theta, z = u/2K, 53 bits
Phi.2 the same, 170 bits
ASKED
cat >"$room/ask.c" <<'C'
#include <acb_elliptic.h>
#include <acb_modular.h>
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

/* sin and cos of half the angle are k sn and dn; k and both functions are quotients of theta functions. */
static void angle(double eta, double u, slong bits)
{
  acb_t m, K, tau, z, theta[8];
  acb_init(m);
  acb_init(K);
  acb_init(tau);
  acb_init(z);
  for(int i = 0; i < 8; ++i) acb_init(theta[i]);
  acb_set_d(m, eta / 2);
  acb_cos(m, m, bits);
  acb_sqr(m, m, bits);
  acb_elliptic_k(K, m, bits);
  acb_sub_si(m, m, 1, bits);
  acb_neg(m, m);
  acb_elliptic_k(tau, m, bits);
  acb_div(tau, tau, K, bits);
  acb_mul_onei(tau, tau);
  acb_modular_theta(theta[0], theta[1], theta[2], theta[3], z, tau, bits);
  acb_set_d(z, u / 2);
  acb_div(z, z, K, bits);
  acb_modular_theta(theta[4], theta[5], theta[6], theta[7], z, tau, bits);
  acb_mul(z, theta[1], theta[4], bits);
  acb_div(z, z, theta[3], bits);
  acb_div(z, z, theta[6], bits);
  acb_atan(z, z, bits);
  acb_mul_2exp_si(z, z, 1);
  say(z);
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
  for(int bits = 53; bits <= 170; bits += 117)
  {
    printf("\nT.%d", bits == 53 ? 1 : 2);
    for(int i = 1; i <= argc / 2; ++i) period(atof(argv[i]), bits);
    printf("\nPhi.%d", bits == 53 ? 1 : 2);
    for(int i = 1; i <= argc / 2; ++i) angle(atof(argv[i]), atof(argv[i + argc / 2]), bits);
  }
  puts("");
  return 0;
}
C
in_room cc -w ask.c -o ask -lflint-arb -lflint -lm
in_room ./ask $eta $u >"$room/said"
as_recorded flint
