#include "elementary/names.hpp"

namespace elementary
{
namespace
{

bool plain = false;

}  // namespace

Plain_names::Plain_names() : before_(plain)
{
  plain = true;
}

Plain_names::~Plain_names()
{
  plain = before_;
}

bool Plain_names::asked()
{
  return plain;
}

}  // namespace elementary
