#include "pendulum/columns.hpp"

#include <stdexcept>

namespace pendulum
{

using exact::Rational;

Rational entry(int m, int j)
{
  if(j < 0 || j >= m)
    throw std::domain_error("row m of the array has the columns 0 to m - 1");
  const Rational a = exact::double_factorial_ratio(m);
  return a * a / (2 * (m - j) * exact::double_factorial_ratio(m - j));
}

exact::Fifty ColumnSum::value() const
{
  return static_cast<exact::Fifty>(beta) * exact::ln2() - static_cast<exact::Fifty>(rho);
}

std::vector<ColumnSum> exact_column_sums(int count)
{
  std::vector<ColumnSum> sums;
  ColumnSum before{0, 0};
  ColumnSum now{1, 0};
  Rational a = 1;  // a_j
  for(int j = 0; j < count; ++j)
  {
    sums.push_back(now);
    const Rational of_now = 2 * j * j + 2 * j + Rational(3, 4);
    const Rational of_before = j * j;
    const Rational square = (j + 1) * (j + 1);
    const ColumnSum next{(of_now * now.beta - of_before * before.beta) / square,
                         (of_now * now.rho - of_before * before.rho + j * a * a / (4 * (j + 1))) / square};
    before = now;
    now = next;
    a *= Rational(2 * j + 1, 2 * j + 2);
  }
  return sums;
}

}  // namespace pendulum
