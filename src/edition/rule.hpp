/// @file
/// What a section gives to the edition to be called.
#pragma once

#include <concepts>
#include <functional>
#include <utility>

namespace edition
{

/// See Rule<Yield(Given...)>.
template <class Signature>
class Rule;

/// A std::function that keeps a lambda without captures, which nearly all of a section's are, as the plain
/// function that it is. Of each lambda that becomes a std::function the compiler makes some twenty functions with
/// libstdc++ and a hundred with libc++ (findings/function-of-lambda), of one that becomes a plain function four.
template <class Yield, class... Given>
class Rule<Yield(Given...)> : public std::function<Yield(Given...)>
{
public:
  /// None.
  Rule() = default;
  /// A plain function, or a lambda that can be one.
  template <std::convertible_to<Yield (*)(Given...)> Plain>
  Rule(Plain plain) : std::function<Yield(Given...)>(kept(plain))
  {
  }
  /// Whatever else can be called.
  template <std::invocable<Given...> Other>
  requires(!std::convertible_to<Other, Yield (*)(Given...)>) Rule(Other other)
      : std::function<Yield(Given...)>(std::move(other))
  {
  }

private:
  static std::function<Yield(Given...)> kept(Yield (*plain)(Given...));
};

}  // namespace edition
