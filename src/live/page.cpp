// What a page's script calls: live.hpp in C. The text that is given back is good until the next call.

#include "live/live.hpp"

namespace
{

const char* kept(std::string answer)
{
  static std::string last;
  last = std::move(answer);
  return last.c_str();
}

}  // namespace

extern "C"
{
  const char* live_tell(const char* name, const char* given, int figures)
  {
    return kept(live::tell(name, given, figures != 0));
  }
  const char* live_frames(const char* name, const char* given)
  {
    return kept(live::frames(name, given));
  }
  const char* live_check(const char* name, const char* given)
  {
    return kept(live::check(name, given));
  }
}
