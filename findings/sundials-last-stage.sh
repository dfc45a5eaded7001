#!/bin/sh
# SUNDIALS 6.4.1 (Debian libsundials-dev 6.4.1+dfsg1-3), ERKStep: a rule of the sixth order converges like one of the third.
#
# The guess: a pair of Runge and Kutta that ARKODE offers has the order in its name, ARKODE_VERNER_8_5_6 the sixth,
# ARKODE_FEHLBERG_13_7_8 the eighth, ARKODE_SAYFY_ABURUB_6_3_4 the fourth; ARKodeButcherTable_CheckOrder confirms it, and the
# tables are right. ERKStep takes every rule whose last stage stands at the end of the step for one that begins the next step
# with it, as that of Dormand and Prince does, though in these three the last stage is not where the step arrives. What the
# next step begins with is the slope at a wrong place, and three orders, one or two are lost; with steps of its own choice
# Verner's pair needs more of them than Dormand's and Prince's of the fifth order, and misses the tolerance by far. A
# pendulum is let go at a right angle and followed for a whole period, in n equal steps, then with the tolerance 1e-12; the
# error is that of angle and speed. Way out: ARKStep with the same table for its explicit part and none for the other.
#
#> ERKStep, Verner 8-5-6, n = 40, 80, 160:      5.3e-04 6.4e-05 8.0e-06
#> ARKStep, the same:                           2.0e-07 1.6e-09 1.4e-11
#> ERKStep, Fehlberg 13-7-8, n = 20, 40:        2.1e-07 2.0e-09
#> ARKStep, the same:                           5.9e-09 1.6e-11
#> ERKStep, Sayfy-Aburub 6-3-4, n = 80, 160:    2.5e-03 6.1e-04
#> ARKStep, the same:                           5.2e-06 2.9e-07
#> ERKStep, Dormand-Prince 7-4-5, n = 40, 80:   9.9e-07 2.4e-08
#> tolerance 1e-12, ERKStep, Verner:            867 steps, 4.1e-08
#> tolerance 1e-12, ARKStep, Verner:            201 steps, 3.1e-12
#> tolerance 1e-12, ERKStep, Dormand-Prince:    416 steps, 5.2e-12
. "$(dirname "$0")/room.sh"
debian libsundials-dev=6.4.1+dfsg1-3
cat >"$room/ask.c" <<'C'
#include <arkode/arkode_arkstep.h>
#include <arkode/arkode_erkstep.h>
#include <math.h>
#include <nvector/nvector_serial.h>
#include <stdio.h>
static const double period = 4 * 1.8540746773013719;
static SUNContext context;
static int pendulum(realtype t, N_Vector y, N_Vector rate, void* unused)
{
  NV_Ith_S(rate, 0) = NV_Ith_S(y, 1);
  NV_Ith_S(rate, 1) = -sin(NV_Ith_S(y, 0));
  return 0;
}
#define FOLLOW(STEP)                                                                                            \
  (n ? STEP##SetFixedStep(memory, period / n) : STEP##SStolerances(memory, tolerance, tolerance),              \
   STEP##SetMaxNumSteps(memory, 100000), STEP##SetStopTime(memory, period),                                     \
   STEP##Evolve(memory, period, y, &t, ARK_NORMAL), STEP##GetNumSteps(memory, steps), STEP##Free(&memory))
static double error(int additive, int table, int n, double tolerance, long* steps)
{
  N_Vector y = N_VNew_Serial(2, context);
  double t;
  void* memory;
  NV_Ith_S(y, 0) = M_PI / 2;
  NV_Ith_S(y, 1) = 0;
  if(additive)
  {
    memory = ARKStepCreate(pendulum, NULL, 0, y, context);
    ARKStepSetTableNum(memory, ARKODE_DIRK_NONE, table);
    FOLLOW(ARKStep);
  }
  else
  {
    memory = ERKStepCreate(pendulum, 0, y, context);
    ERKStepSetTableNum(memory, table);
    FOLLOW(ERKStep);
  }
  return fabs(NV_Ith_S(y, 0) - M_PI / 2) + fabs(NV_Ith_S(y, 1));
}
static void tell(const char* name, int additive, int table, int from, int until)
{
  long steps;
  printf("%-44s", name);
  for(; from <= until; from *= 2)
    printf(" %.1e", error(additive, table, from, 0, &steps));
  puts("");
}
static void tell_steps(const char* name, int additive, int table)
{
  long steps;
  const double e = error(additive, table, 0, 1e-12, &steps);
  printf("%-44s %ld steps, %.1e\n", name, steps, e);
}
int main(void)
{
  SUNContext_Create(NULL, &context);
  tell("ERKStep, Verner 8-5-6, n = 40, 80, 160:", 0, ARKODE_VERNER_8_5_6, 40, 160);
  tell("ARKStep, the same:", 1, ARKODE_VERNER_8_5_6, 40, 160);
  tell("ERKStep, Fehlberg 13-7-8, n = 20, 40:", 0, ARKODE_FEHLBERG_13_7_8, 20, 40);
  tell("ARKStep, the same:", 1, ARKODE_FEHLBERG_13_7_8, 20, 40);
  tell("ERKStep, Sayfy-Aburub 6-3-4, n = 80, 160:", 0, ARKODE_SAYFY_ABURUB_6_3_4, 80, 160);
  tell("ARKStep, the same:", 1, ARKODE_SAYFY_ABURUB_6_3_4, 80, 160);
  tell("ERKStep, Dormand-Prince 7-4-5, n = 40, 80:", 0, ARKODE_DORMAND_PRINCE_7_4_5, 40, 80);
  tell_steps("tolerance 1e-12, ERKStep, Verner:", 0, ARKODE_VERNER_8_5_6);
  tell_steps("tolerance 1e-12, ARKStep, Verner:", 1, ARKODE_VERNER_8_5_6);
  tell_steps("tolerance 1e-12, ERKStep, Dormand-Prince:", 0, ARKODE_DORMAND_PRINCE_7_4_5);
  return 0;
}
C
in_room cc -O1 -w ask.c -o ask -lsundials_arkode -lsundials_nvecserial -lsundials_generic -lm
in_room ./ask >"$room/seen"
as_seen "$room/seen"
