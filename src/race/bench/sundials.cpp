#include "race/bench/sundials.hpp"

#ifdef HAS_SUNDIALS

#include <algorithm>
#include <new>

#include <arkode/arkode_arkstep.h>
#include <cvode/cvode.h>
#include <cvode/cvode_diag.h>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_context.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

namespace bench::sundials
{
namespace
{

// What both need: the numbers, and what moves them.
class Numbers
{
public:
  Numbers(Slope slope, const std::shared_ptr<void>& of, std::size_t n) : slope_(slope), of_(of), n_(n)
  {
    if(SUNContext_Create(nullptr, &context_) != 0)
      throw std::bad_alloc();
    y_ = N_VNew_Serial(static_cast<sunindextype>(n), context_);
    if(y_ == nullptr)
      throw std::bad_alloc();
  }
  ~Numbers()
  {
    N_VDestroy(y_);
    SUNContext_Free(&context_);
  }
  Numbers(const Numbers&) = delete;
  Numbers& operator=(const Numbers&) = delete;

  static int slope(realtype t, N_Vector y, N_Vector slope, void* numbers)
  {
    const Numbers& self = *static_cast<const Numbers*>(numbers);
    return self.slope_(t, NV_DATA_S(y), NV_DATA_S(slope), self.of_.get());
  }
  SUNContext context() const { return context_; }
  N_Vector y() const { return y_; }
  void set(const double* y) { std::copy_n(y, n_, NV_DATA_S(y_)); }
  void get(double* y) const { std::copy_n(NV_DATA_S(y_), n_, y); }

private:
  Slope slope_;
  std::shared_ptr<void> of_;
  std::size_t n_;
  SUNContext context_{};
  N_Vector y_{};
};

constexpr long steps = 1000000;  // enough for all, and an end where the tolerance cannot be had

// Both are told to stop at the time asked for: what they would interpolate is of a lower order than their steps. And both
// are made anew for each motion, as a user would. ARKODE's explicit rules are asked through ARKStep, for ERKStep loses
// their order (findings/sundials-last-stage.sh); of its controllers the plainest does best here.
bool by_arkode(Numbers& numbers, double* y, double t, double tolerance, ARKODE_ERKTableID pair)
{
  numbers.set(y);
  void* memory = ARKStepCreate(Numbers::slope, nullptr, 0, numbers.y(), numbers.context());
  if(memory == nullptr)
    throw std::bad_alloc();
  ARKStepSetErrFile(memory, nullptr);
  ARKStepSetUserData(memory, &numbers);
  ARKStepSetTableNum(memory, ARKODE_DIRK_NONE, pair);
  ARKStepSetAdaptivityMethod(memory, ARK_ADAPT_I, 1, 0, nullptr);
  ARKStepSStolerances(memory, tolerance, tolerance);
  ARKStepSetMaxNumSteps(memory, steps);
  ARKStepSetStopTime(memory, t);
  double reached = 0;
  const bool there = ARKStepEvolve(memory, t, numbers.y(), &reached, ARK_NORMAL) >= 0;
  ARKStepFree(&memory);
  numbers.get(y);
  return there;
}

// Adams's rule iterates; that for stiff equations has Newton's method, with the diagonal of their matrix alone.
bool by_cvode(Numbers& numbers, double* y, double t, double tolerance, int rule)
{
  numbers.set(y);
  void* memory = CVodeCreate(rule, numbers.context());
  SUNNonlinearSolver solver =
      rule == CV_ADAMS ? SUNNonlinSol_FixedPoint(numbers.y(), 0, numbers.context()) : nullptr;
  if(memory == nullptr || (rule == CV_ADAMS && solver == nullptr))
    throw std::bad_alloc();
  CVodeSetErrFile(memory, nullptr);
  CVodeInit(memory, Numbers::slope, 0, numbers.y());
  CVodeSetUserData(memory, &numbers);
  CVodeSStolerances(memory, tolerance, tolerance);
  if(solver != nullptr)
    CVodeSetNonlinearSolver(memory, solver);
  else
    CVDiag(memory);
  CVodeSetMaxNumSteps(memory, steps);
  CVodeSetStopTime(memory, t);
  double reached = 0;
  const bool there = CVode(memory, t, numbers.y(), &reached, CV_NORMAL) >= 0;
  CVodeFree(&memory);
  if(solver != nullptr)
    SUNNonlinSolFree(solver);
  numbers.get(y);
  return there;
}

}  // namespace

std::vector<Way> ways(Slope slope, const std::shared_ptr<void>& of, std::size_t n, double tolerance)
{
  const auto numbers = std::make_shared<Numbers>(slope, of, n);
  const auto arkode = [=](ARKODE_ERKTableID pair) {
    return [=](double* y, double t) { return by_arkode(*numbers, y, t, tolerance, pair); };
  };
  return {
      {"ARKODE Fehlberg 13-7-8", arkode(ARKODE_FEHLBERG_13_7_8)},
      {"ARKODE Verner 8-5-6", arkode(ARKODE_VERNER_8_5_6)},
      {"CVODE Adams", [=](double* y, double t) { return by_cvode(*numbers, y, t, tolerance, CV_ADAMS); }}};
}

std::vector<Way> stiff_ways(Slope slope, const std::shared_ptr<void>& of, double tolerance)
{
  const auto number = std::make_shared<Numbers>(slope, of, 1);
  return {{"CVODE BDF", [=](double* y, double t) { return by_cvode(*number, y, t, tolerance, CV_BDF); }}};
}

std::vector<std::string> left_out()
{
  return {};
}

}  // namespace bench::sundials

#else

namespace bench::sundials
{

std::vector<Way> ways(Slope, const std::shared_ptr<void>&, std::size_t, double)
{
  return {};
}

std::vector<Way> stiff_ways(Slope, const std::shared_ptr<void>&, double)
{
  return {};
}

std::vector<std::string> left_out()
{
  return {"SUNDIALS"};
}

}  // namespace bench::sundials

#endif
