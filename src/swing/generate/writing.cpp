#include "writing.hpp"

#include <cmath>

namespace generate
{

std::string hex(double x)
{
  char text[40];
  std::snprintf(text, sizeof text, "%a", x);
  return text;
}

std::vector<double> rounded(const std::vector<exact::Fifty>& c)
{
  std::vector<double> d;
  for(const exact::Fifty& x : c)
    d.push_back(static_cast<double>(x));
  return d;
}

std::string bits(const exact::Fifty& error)
{
  char text[40];
  std::snprintf(text, sizeof text, "2^%.1f", std::log2(static_cast<double>(abs(error))));
  return text;
}

void write_array(std::FILE* out, const std::string& name, const std::string& comment,
                 const std::vector<double>& c)
{
  std::fprintf(out, "\n// %s\ninline constexpr double %s[] = {", comment.c_str(), name.c_str());
  for(std::size_t i = 0; i < c.size(); ++i)
    std::fprintf(out, "%s%s", i == 0 ? "\n    " : i % 4 == 0 ? ",\n    " : ", ", hex(c[i]).c_str());
  std::fprintf(out, "};\n");
}

}  // namespace generate
