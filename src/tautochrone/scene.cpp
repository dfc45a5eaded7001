#include "tautochrone/scene.hpp"

#include "edition/scene.hpp"
#include "tautochrone/euler.hpp"
#include "tautochrone/member.hpp"
#include "tautochrone/thread.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include <gsl/gsl_integration.h>

namespace tautochrone
{
namespace
{

constexpr double quarter_turn = std::numbers::pi / 2;
constexpr int pieces = 64;
constexpr double part = quarter_turn / pieces;
constexpr std::size_t places = 8;

const gsl_integration_glfixed_table& rule()
{
  static const gsl_integration_glfixed_table* const table = gsl_integration_glfixed_table_alloc(places);
  return *table;
}

// M and G from A, to the right and upwards.
struct Places
{
  double M_x, M_y, G_x, G_y;
};

Places places_at(double k, double phi)  // k of the cheek: 0 for a cycloid
{
  return {euler_q<double>(1, k, phi), -euler_p<double>(1, k, phi), euler_y<double>(1, k, phi),
          euler_x<double>(1, k, phi) - 1};
}

edition::Body cheek(double k, double to)
{
  std::vector<edition::Spot> joints;
  for(int i = 0; i <= 40; ++i)
  {
    const Places at = places_at(k, to * i / 40);
    joints.push_back({at.M_x, at.M_y});
  }
  return edition::drawn::rod(joints, "ink");
}

}  // namespace

Timed_swing::Timed_swing(Cheeks cheeks, double k, double phi0)
    : cheeks_(cheeks), k_(k), half_sine_(std::sin(phi0 / 2)), c0_(std::cos(phi0)), reached_{0}
{
  const bool smooth = cheeks == Cheeks::cycloids || k < 1e-9;  // no end before 90°, to all digits
  if(!(k >= 0 && k <= 1e20 && phi0 > 0 && phi0 < largest_amplitude(cheeks, smooth ? 0 : k)))
    throw std::domain_error("a swing needs 0 ≤ k/a ≤ 1e20 and an angle that its curve rises to");
  for(int i = 0; i < pieces; ++i)
    reached_.push_back(reached_.back() + between(i * part, part));
}

double Timed_swing::element(double alpha) const
{
  const double phi = 2 * std::asin(half_sine_ * std::cos(alpha)), c = std::cos(phi);
  double rise = 1;  // (c − x)/(cos φ − cos φ₀)
  double r = 1;
  if(cheeks_ == Cheeks::cycloids)
  {
    rise = (c + c0_) / 2;
    r = c;
  }
  else if(cheeks_ != Cheeks::none)
  {
    const int corrections = cheeks_ == Cheeks::euler_k4 ? 2 : 1;
    rise = (c + c0_) * rise_of_euler<double>(corrections, k_, 1 / (c0_ * c0_), 1 / (c * c));
    r = on_euler<double>(corrections, k_, phi, phi).r;
  }
  return std::numbers::sqrt2 * std::hypot(k_, r) / std::sqrt(rise) / std::cos(phi / 2);
}

double Timed_swing::between(double alpha, double further) const
{
  double sum = 0;
  for(std::size_t i = 0; i < places; ++i)
  {
    double x = 0, weight = 0;
    gsl_integration_glfixed_point(0, further, i, &x, &weight, &rule());
    sum += weight * element(alpha + x);
  }
  return sum;
}

double Timed_swing::angle(double t) const
{
  const double quarter = reached_.back(), quarters = std::floor(t / quarter);
  const double within = std::clamp(t - quarters * quarter, 0., quarter);
  const int which = static_cast<int>(std::fmod(quarters, 4));  // down, up, down from the other side, up
  const double left = which % 2 == 0 ? within : quarter - within;
  const auto next = std::upper_bound(reached_.begin() + 1, reached_.end() - 1, left);
  const double start = part * static_cast<double>(next - reached_.begin() - 1);
  double further = part * (left - *(next - 1)) / (*next - *(next - 1));
  for(int step = 0; step < 4; ++step)
    further += (left - *(next - 1) - between(start, further)) / element(start + further);
  const double phi = 2 * std::asin(half_sine_ * std::cos(start + further));
  return which == 0 || which == 3 ? phi : -phi;
}

std::vector<Hung> hung_between(Cheeks cheeks, double k, double phi0, int n, int last)
{
  if(cheeks != Cheeks::cycloids && cheeks != Cheeks::euler_k4)
    throw std::domain_error("a scene is of cycloids or of Euler's cheeks");
  const Timed_swing swing(cheeks, k, phi0);
  const double T = small_swing(k);
  std::vector<Hung> result;
  for(int i = 0; i <= last; ++i)
  {
    const double phi = swing.angle(T * i / n);
    const Places at = places_at(cheeks == Cheeks::cycloids ? 0 : k, phi);
    result.push_back({phi, at.M_x, at.M_y, at.G_x, at.G_y});
  }
  return result;
}

std::vector<Hung> hung_on_highest(double k, double phi0, int n, int last)
{
  if(!(n > 0 && n % 2 == 0 && k >= 0.02 && k <= 0.9 && phi0 >= 1e-3))
    throw std::domain_error(
        "a scene on the exact curve needs 0.02 ≤ k/a ≤ 0.9 and an angle of 0.001 or more");
  const double root = std::sqrt(at(Member::highest, k, phi0).x);
  std::vector<double> angles(static_cast<std::size_t>(n / 2 + 1));  // at even times, from the lowest place
  angles.back() = phi0;
  double guess = phi0;
  for(std::size_t i = angles.size() - 2; i > 0; --i)
  {
    const double wanted = root * std::sin(std::numbers::pi * static_cast<double>(i) / n);
    for(int step = 0; step < 5; ++step)
    {
      const Position now = at(Member::highest, k, guess);
      guess -= (std::sqrt(now.x) - wanted) * 2 * std::sqrt(now.x) / (now.r * std::sin(guess));
    }
    angles[i] = guess;
  }
  const std::vector<Drawn> quarter = drawn(Member::highest, k, angles);
  std::vector<Hung> result;
  for(int i = 0; i <= last; ++i)
  {
    const int left = n / 2 - i % n;  // steps to the lowest place
    const Drawn& now = quarter.at(static_cast<std::size_t>(std::abs(left)));
    const double side = (i / n % 2 == 0) == (left >= 0) ? 1 : -1;
    result.push_back({side * now.at.phi, side * now.q, -now.p, side * now.y, now.at.x - 1});
  }
  return result;
}

double clock_in_seconds(double a, double g)
{
  return std::sqrt(a) / (2 * std::sqrt(g));
}

void scene_between_cheeks(const char* name, Cheeks cheeks, double k, double phi0, double unit)
{
  if(cheeks != Cheeks::cycloids && cheeks != Cheeks::euler_k4)
    throw std::domain_error("a scene is of cycloids or of Euler's cheeks");
  const Timed_swing swing(cheeks, k, phi0);
  const double k_of_cheek = cheeks == Cheeks::cycloids ? 0 : k;
  namespace drawn = edition::drawn;
  const edition::Spot M{"M_x", "M_y"}, G{"G_x", "G_y"}, upper{"upper_x", "upper_y"},
      lower{"lower_x", "lower_y"};
  std::vector<edition::Body> bodies{cheek(k_of_cheek, phi0), cheek(k_of_cheek, -phi0), drawn::trail(G)};
  std::vector<std::string> columns{"t", "phi", "M_x", "M_y", "G_x", "G_y"};
  if(k > 0)
  {
    bodies.push_back(drawn::rod({M, G, lower, upper}, "blue"));
    bodies.push_back(drawn::bob(upper, 0.03));
    bodies.push_back(drawn::bob(lower, 0.03));
    bodies.push_back(drawn::bob(G, 0.015, "ink"));
    columns.insert(columns.end(), {"upper_x", "upper_y", "lower_x", "lower_y"});
  }
  else
  {
    bodies.push_back(drawn::rod({M, G}, "blue"));
    bodies.push_back(drawn::bob(G, 0.05));
  }
  edition::scene(name, bodies, columns, [&](edition::Curve& frames) {
    constexpr int many = 240;
    for(int i = 0; i <= many; ++i)
    {
      const double t = 2 * swing.time() * i / many, phi = swing.angle(t), s = std::sin(phi),
                   c = std::cos(phi);
      const Places at = places_at(k_of_cheek, phi);
      std::vector<double> row{unit * t, phi, at.M_x, at.M_y, at.G_x, at.G_y};
      if(k > 0)
        row.insert(row.end(), {at.G_x - k * s, at.G_y + k * c, at.G_x + k * s, at.G_y - k * c});
      frames.put(row);
    }
  });
}

}  // namespace tautochrone
