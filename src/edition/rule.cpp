#include "edition/rule.hpp"

#include "edition/tell.hpp"

namespace edition
{

template <class Yield, class... Given>
std::function<Yield(Given...)> Rule<Yield(Given...)>::kept(Yield (*plain)(Given...))
{
  return plain;
}
template class Rule<double()>;
template class Rule<bool(double)>;
template class Rule<exact::Fifty()>;
template class Rule<void(Curve&)>;

}  // namespace edition
