#include "globe/judge.hpp"

#include <algorithm>
#include <stdexcept>

namespace globe::oracle
{

using exact::Fifty;

// x, dx/dt, Φ, dΦ/dt
exact::State Judge::of_G(const State<Fifty>& at) const
{
  const auto& [a, c, k, gap] = ball_;
  return {at.s - c * sin(at.Phi), at.slip + (a - c * cos(at.Phi)) * at.w, at.Phi, at.w};
}

State<Fifty> Judge::of_contact(const exact::State& G, Mode mode) const
{
  const auto& [a, c, k, gap] = ball_;
  const Fifty slip = mode == Mode::rolling ? Fifty(0) : Fifty(G[1] - (a - c * cos(G[2])) * G[3]);
  return {G[0] + c * sin(G[2]), slip, G[2], G[3]};
}

exact::State Judge::forwards(const exact::State& G, Mode mode) const
{
  const Fifty lambda = mode == Mode::scraping_forwards ? mu_ : Fifty(-mu_);
  const auto moved = mode == Mode::rolling ? rolling_accelerations(ball_, g_, G[2], G[3])
                                           : accelerations(ball_, g_, G[2], G[3], lambda);
  return {G[1], moved.x, G[3], moved.Phi};
}

std::array<Fifty, 3> Judge::margins(const State<Fifty>& at, Mode mode) const
{
  const Fifty bears = 1 + ball_.c * at.w * at.w * cos(at.Phi) / (2 * g_);
  if(mode != Mode::rolling)
    return {mode == Mode::scraping_forwards ? at.slip : Fifty(-at.slip), bears, bears};
  const auto moved = rolling_accelerations(ball_, g_, at.Phi, at.w);
  const Fifty backwards = -moved.x / (2 * g_), most = mu_ * moved.pressure;
  return {most - backwards, most + backwards, bears};
}

Mode Judge::without_slip(const State<Fifty>& at) const
{
  const std::array<Fifty, 3> margin = margins(at, Mode::rolling);
  return margin[0] < 0 ? Mode::scraping_forwards : margin[1] < 0 ? Mode::scraping_backwards : Mode::rolling;
}

State<Fifty> Judge::after(const State<Fifty>& from, Mode mode, const Fifty& time) const
{
  if(time == 0)
    return from;
  const auto motion = [&](const Fifty&, const exact::State& G) { return forwards(G, mode); };
  return of_contact(exact::solve(motion, 0, of_G(from), time, Fifty("1e-17")).y, mode);
}

// The same where the square of the time does not count.
State<Fifty> Judge::in_a_moment(const State<Fifty>& from, Mode mode, const Fifty& time) const
{
  exact::State G = of_G(from);
  const exact::State rate = forwards(G, mode);
  for(std::size_t i = 0; i < G.size(); ++i)
    G[i] += time * rate[i];
  return of_contact(G, mode);
}

// Whether all margins are positive at the second of two states that are so far apart, and between them by the cubic
// that has the values and the slopes at both.
bool Judge::may(const State<Fifty>& from, const State<Fifty>& to, Mode mode, const Fifty& time) const
{
  const Fifty h("1e-20");
  const auto begin = margins(from, mode), end = margins(to, mode);
  const auto begins = margins(in_a_moment(from, mode, h), mode),
             ends = margins(in_a_moment(to, mode, h), mode);
  for(std::size_t i = 0; i < begin.size(); ++i)
  {
    // m + s x + p xx + q xxx, x from 0 to 1
    const Fifty& m = begin[i];
    if(end[i] <= 0)
      return false;
    const Fifty s = (begins[i] - m) / h * time, rise = end[i] - m, last = (ends[i] - end[i]) / h * time;
    const Fifty p = 3 * rise - 2 * s - last, q = s + last - 2 * rise;
    const Fifty root = p * p - 3 * q * s;
    if(root <= 0)
      continue;
    const Fifty x = -s / (p + sqrt(root));  // where it is least
    if(x > Fifty("0.01") && x < Fifty("0.99") && m + x * (s + x * (p + x * q)) <= 0)
      return false;
  }
  return true;
}

Fifty Judge::longest_step(const State<Fifty>& at) const
{
  const Fifty swings = sqrt(g_ * (1 / ball_.a + ball_.c / (ball_.k * ball_.k)));
  return 1 / (2 * (abs(at.w) + swings));
}

// What begins with the change that comes within so short a time, its `from` counted from now; nothing if it is not
// yet seen which margin vanishes.
std::optional<Stretch> Judge::next(const State<Fifty>& now, Mode mode, const Fifty& soon) const
{
  const Fifty h("1e-20");
  const auto begin = margins(now, mode), end = margins(after(now, mode, soon), mode);
  std::size_t which = begin.size();
  Fifty time = soon;
  for(std::size_t i = 0; i < begin.size(); ++i)  // the first to vanish, by the chord
    if(begin[i] > 0 && end[i] <= 0 && begin[i] * soon <= time * (begin[i] - end[i]))
      which = i, time = begin[i] * soon / (begin[i] - end[i]);
  if(which == begin.size())
    return std::nullopt;
  State<Fifty> there = after(now, mode, time);
  Fifty correction = soon;
  while(abs(correction) > Fifty("1e-12") * soon)  // Newton
  {
    const Fifty here = margins(there, mode)[which];
    correction = -here * h / (margins(in_a_moment(there, mode, h), mode)[which] - here);
    if(abs(correction) > soon)
      return std::nullopt;
    time += correction;
    there = after(now, mode, time);
  }
  if(mode == Mode::rolling && which < 2)
    return Stretch{time, which == 0 ? Mode::scraping_forwards : Mode::scraping_backwards, there};
  if(which > 0)
    return Stretch{time, Mode::off, there};
  there.slip = 0;
  return Stretch{time, without_slip(there), there};
}

const Stretch& stretch_at(const std::vector<Stretch>& motion, const Fifty& t)
{
  return *std::prev(
      std::find_if(motion.begin() + 1, motion.end(), [&](const Stretch& s) { return s.from > t; }));
}

State<Fifty> Judge::at(const std::vector<Stretch>& motion, const Fifty& t) const
{
  const Stretch& now = stretch_at(motion, t);
  return after(now.start, now.mode, t - now.from);
}

Fifty Judge::energy(const State<Fifty>& at) const
{
  const auto& [a, c, k, gap] = ball_;
  const Fifty y = a - c * cos(at.Phi), dx = at.slip + y * at.w, dy = c * at.w * sin(at.Phi);
  return (dx * dx + dy * dy + k * k * at.w * at.w) / 2 + 2 * g_ * y;
}

std::vector<Stretch> Judge::stretches(const State<Fifty>& start, const Fifty& end,
                                      std::size_t most_changes) const
{
  Mode mode = start.slip > 0   ? Mode::scraping_forwards
              : start.slip < 0 ? Mode::scraping_backwards
                               : without_slip(start);
  std::vector<Stretch> all{{0, mode, start}};
  State<Fifty> now = start;
  Fifty t = 0, step = longest_step(now) / 8;
  bool comes = false;  // a change, within the next step and as much again
  while(t < end && all.back().mode != Mode::off && all.size() <= most_changes)
  {
    const Fifty longest = longest_step(now);
    step = std::min(step, longest);
    const bool to_the_end = t + step >= end;
    if(to_the_end)
      step = end - t;
    const State<Fifty> there = after(now, mode, step);
    if(may(now, there, mode, step))
      now = there, t = to_the_end ? end : t + step;
    else
      comes = true;
    step *= comes ? Fifty(0.5) : Fifty(2);
    if(!comes || step > longest / 128)
      continue;
    const std::optional<Stretch> changed = next(now, mode, 2 * step);
    if(!changed && step < longest * Fifty("1e-15"))
      throw std::runtime_error("two changes are too near to each other for the judge");
    if(!changed)
      continue;
    now = changed->start, mode = changed->mode, t += changed->from;
    all.push_back({t, mode, now});
    step = longest / 8;
    comes = false;
  }
  return all;
}

}  // namespace globe::oracle
