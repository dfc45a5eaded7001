#include "globe/judge.hpp"

#include <algorithm>

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

// The least to which a margin dips between two states that are so far apart, if one does: by the cubic that has the
// values and the slopes at both. Else 1.
Fifty Judge::least_between(const State<Fifty>& from, const State<Fifty>& to, Mode mode,
                           const Fifty& time) const
{
  const Fifty h("1e-20");
  const auto begin = margins(from, mode), end = margins(to, mode);
  const auto begins = margins(in_a_moment(from, mode, h), mode),
             ends = margins(in_a_moment(to, mode, h), mode);
  Fifty least = 1;
  for(std::size_t i = 0; i < begin.size(); ++i)
  {
    // m + s x + p xx + q xxx, x from 0 to 1
    const Fifty& m = begin[i];
    const Fifty s = (begins[i] - m) / h * time, rise = end[i] - m, last = (ends[i] - end[i]) / h * time;
    const Fifty p = 3 * rise - 2 * s - last, q = s + last - 2 * rise;
    const Fifty root = p * p - 3 * q * s;
    if(root <= 0)
      continue;
    const Fifty x = -s / (p + sqrt(root));  // where it is least
    if(x > Fifty("0.01") && x < Fifty("0.99"))
      least = std::min(least, Fifty(m + x * (s + x * (p + x * q))));
  }
  return least;
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

std::vector<Stretch> Judge::stretches(const State<Fifty>& start, const std::vector<double>& told) const
{
  const Mode first = start.slip > 0   ? Mode::scraping_forwards
                     : start.slip < 0 ? Mode::scraping_backwards
                                      : without_slip(start);
  std::vector<Stretch> all{{0, first, start, 1}};
  for(const double change : told)
  {
    Stretch& last = all.back();
    const Mode mode = last.mode;
    Fifty t = change;
    const Fifty length = t - last.from;
    State<Fifty> now = last.start;
    int before = 0;
    for(const int part : {1, 9, 17, 25, 33, 41, 49, 50})
    {
      const State<Fifty> from = now;
      now = after(now, mode, (part - before) * length / 50);
      last.margin = std::min(last.margin, least_between(from, now, mode, (part - before) * length / 50));
      before = part;
      if(part < 50)
        for(const Fifty& margin : margins(now, mode))
          last.margin = std::min(last.margin, margin);
    }
    const std::array<Fifty, 3> margin = margins(now, mode);
    const auto which = static_cast<std::size_t>(std::distance(
        margin.begin(), std::min_element(margin.begin(), margin.end(),
                                         [](const Fifty& p, const Fifty& q) { return abs(p) < abs(q); })));
    for(int i = 0; i < 2; ++i)  // Newton
    {
      const Fifty h("1e-20"), here = margins(now, mode)[which];
      const Fifty correction = -here * h / (margins(in_a_moment(now, mode, h), mode)[which] - here);
      now = in_a_moment(now, mode, correction);
      t += correction;
    }
    Mode then = Mode::off;
    if(mode == Mode::rolling && which < 2)
      then = which == 0 ? Mode::scraping_forwards : Mode::scraping_backwards;
    else if(mode != Mode::rolling && which == 0)
    {
      now.slip = 0;
      then = without_slip(now);
    }
    all.push_back({t, then, now, 1});
  }
  return all;
}

}  // namespace globe::oracle
