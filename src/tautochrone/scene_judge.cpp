#include "tautochrone/scene_judge.hpp"

#include "exact/ode.hpp"
#include "tautochrone/series.hpp"

#include <algorithm>

namespace tautochrone
{
namespace
{

/// The times of these frames, which tell seconds, in this unit.
std::vector<exact::Fifty> times_of(const std::vector<edition::ToldRow>& frames, const exact::Fifty& unit)
{
  std::vector<exact::Fifty> times;
  for(const edition::ToldRow& frame : frames)
    times.push_back(frame.at("t") / unit);
  return times;
}

}  // namespace

std::vector<Judged_frame> judged(const std::vector<edition::ToldRow>& frames, Cheeks cheeks,
                                 const exact::Fifty& k, const exact::Fifty& phi0, const exact::Fifty& unit)
{
  using exact::Fifty;
  const auto r = truncated(cheeks == Cheeks::cycloids ? 0 : 2, k);
  const Fifty T = exact::pi() * sqrt(2 * (1 + k * k)) * (1 + excess(r, k, phi0));
  std::vector<Fifty> times;
  for(std::size_t i = 0; i < frames.size(); ++i)
    times.push_back(2 * T * static_cast<int>(i) / static_cast<int>(frames.size() - 1));
  const auto places = places_by_motion(r, k, phi0, times);
  std::vector<Judged_frame> result;
  for(std::size_t i = 0; i < frames.size(); ++i)
  {
    const On_curve& at = places[i];
    const Fifty s = sin(at.phi), c = cos(at.phi), x = at.y, y = at.x - 1;
    Judged_frame frame{frames[i], unit * times[i], {}, 1e-13 * (1 + static_cast<double>(k))};
    frame.right = {{"phi", at.phi}, {"M_x", x - at.r * s}, {"M_y", y + at.r * c}, {"G_x", x}, {"G_y", y}};
    if(k > 0)
      for(const auto& [name, l] : {std::pair<std::string, Fifty>{"upper", -k}, {"lower", k}})
      {
        frame.right.emplace_back(name + "_x", x + l * s);
        frame.right.emplace_back(name + "_y", y - l * c);
      }
    result.push_back(frame);
  }
  return result;
}

std::vector<On_curve> places_between(const std::vector<edition::ToldRow>& frames, Cheeks cheeks,
                                     const exact::Fifty& k, const exact::Fifty& phi0,
                                     const exact::Fifty& unit)
{
  return places_by_motion(truncated(cheeks == Cheeks::cycloids ? 0 : 2, k), k, phi0,
                          times_of(frames, unit));
}

std::vector<On_curve> on_highest(const exact::Fifty& k, const exact::Fifty& phi0,
                                 const std::vector<exact::Fifty>& swings,
                                 const std::vector<exact::Fifty>& near)
{
  using exact::Fifty;
  const Fifty kk = k * k, lowest("1e-9");
  std::vector<On_curve> places(swings.size());
  const auto falling_angles = [&] {  // which of the places, the highest first
    std::vector<std::size_t> order(places.size());
    for(std::size_t i = 0; i < order.size(); ++i)
      order[i] = i;
    std::sort(order.begin(), order.end(),
              [&](std::size_t i, std::size_t j) { return places[i].phi > places[j].phi; });
    return order;
  };
  const auto put_radii = [&] {  // of all places, on one way down
    std::vector<Fifty> angles;
    const auto order = falling_angles();
    for(auto i = order.rbegin(); i != order.rend(); ++i)
      if(places[*i].phi > lowest)
        angles.push_back(places[*i].phi);
    auto radii = highest(k, angles);
    for(const std::size_t i : order)
    {
      const bool low = radii.empty();
      places[i].r = low ? Fifty(1) : radii.back();
      if(!low)
        radii.pop_back();
    }
  };
  const auto root = [&](const Fifty& r, const Fifty& to) -> Fifty {  // of the height, by (2) of §25
    return sqrt((1 + kk) / 2 / (kk + r * r)) * r * sin(to);
  };
  const Fifty whole = root(highest(k, phi0), phi0);
  for(std::size_t i = 0; i < places.size(); ++i)
    places[i].phi = abs(near[i]);
  put_radii();
  for(std::size_t i = 0; i < places.size(); ++i)
  {
    On_curve& at = places[i];
    const Fifty wanted = whole * abs(cos(exact::pi() * swings[i]));
    at.phi -= (root(at.r, at.phi) - wanted) * sqrt(2 * (1 + kk) / (kk + at.r * at.r));
    at.phi = std::clamp(at.phi, Fifty(0), phi0);
    at.x = wanted * wanted;
  }
  put_radii();
  // The breadth is followed down the equation with r, by h = 1 − cos φ. Below `low` 1 − r grows as φφ, or is too small
  // to be seen.
  const bool smooth = kk < Fifty("0.3");
  const Fifty low(smooth ? "1e-5" : "1e-13");
  const auto below = [&](const Fifty& r, const Fifty& to) -> Fifty {
    return smooth ? to * (1 - (1 - r) / 3 - to * to / 6) : to;
  };
  const auto h_of = [](const Fifty& to) -> Fifty { return 2 * pow(sin(to / 2), 2); };
  const auto order = falling_angles();
  std::vector<Fifty> heights;
  for(const std::size_t i : order)
    if(places[i].phi > low)
      heights.push_back(h_of(places[i].phi));
  heights.push_back(h_of(low));
  const auto down = exact::solve(
      [&](const Fifty& h, const exact::State& at) -> exact::State {
        const Fifty u = kk + at[0] * at[0], sine2 = h * (2 - h);
        return {u * (u - (1 + kk) * at[0] * (1 - h)) / (kk * (1 + kk) * sine2),
                at[0] * (1 - h) / sqrt(sine2)};
      },
      heights.front(), {places[order.front()].r, 0}, heights, Fifty("1e-16"));
  for(std::size_t j = 0; j < order.size(); ++j)
  {
    On_curve& at = places[order[j]];
    at.y = j + 1 < down.size() ? below(down.back().y[0], low) + down[j].y[1] - down.back().y[1]
                               : below(at.r, at.phi);
    if(cos(exact::pi() * swings[order[j]]) < 0)
    {
      at.phi = -at.phi;
      at.y = -at.y;
    }
  }
  return places;
}

std::vector<On_curve> on_highest(const std::vector<edition::ToldRow>& frames, const exact::Fifty& k,
                                 const exact::Fifty& phi0, const exact::Fifty& T)
{
  std::vector<exact::Fifty> near;
  for(const edition::ToldRow& frame : frames)
    near.emplace_back(frame.at("exact_phi"));
  return on_highest(k, phi0, times_of(frames, T), near);
}

}  // namespace tautochrone
