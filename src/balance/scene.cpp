#include "balance/scene.hpp"

#include <algorithm>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include "edition/scene.hpp"

namespace balance
{
namespace
{

/// Declares the scene `name`: shears, beam, strings and pans, 24 frames in a turn of `fastest` radians a
/// second, at least 240, at most 2000, and no longer than `until` seconds nor than so many frames reach.
/// Columns: t, and the joints C_x to Q_y. `at` gives the joints at times that grow. An `until` of 0 has no
/// scene.
void scene_of_joints(const char* name, double until, double fastest, double size, bool shears,
                     const std::function<Joints<double>(double t)>& at)
{
  constexpr double of_a_turn = 24, least = 240, most = 2000;
  const double turn = 2 * std::numbers::pi / fastest, end = std::min(until, most / of_a_turn * turn);
  if(!(end > 0))
    return;
  namespace drawn = edition::drawn;
  const edition::Spot O{0., 0.}, C{"C_x", "C_y"}, A{"A_x", "A_y"}, B{"B_x", "B_y"}, P{"P_x", "P_y"},
      Q{"Q_x", "Q_y"};
  std::vector<edition::Body> bodies;
  if(shears)
  {
    bodies.push_back(drawn::rod({O, C}, "grey"));
    bodies.push_back(drawn::bob(O, size / 4, "ink"));
  }
  for(const edition::Body& body :
      {drawn::rod({A, P}, "grey"), drawn::rod({B, Q}, "grey"), drawn::rod({A, C, B}),
       drawn::bob(C, size / 4, "ink"), drawn::bob(P, size), drawn::bob(Q, size, "vermilion")})
    bodies.push_back(body);
  std::vector<std::string> columns{"t"};
  for(const auto& column : by_name({}))
    columns.emplace_back(column.first);
  edition::scene(name, bodies, columns, [&](edition::Curve& frames) {
    const int many = static_cast<int>(std::clamp(std::ceil(of_a_turn * end / turn), least, most));
    for(int i = 0; i <= many; ++i)
    {
      const double t = end * i / many;
      std::vector<double> row{t};
      for(const auto& column : by_name(at(t)))
        row.push_back(column.second);
      frames.put(row);
    }
  });
}

}  // namespace

std::array<std::pair<const char*, double>, 10> by_name(const Joints<double>& j)
{
  return {{{"C_x", j.C_x},
           {"C_y", j.C_y},
           {"A_x", j.A_x},
           {"A_y", j.A_y},
           {"B_x", j.B_x},
           {"B_y", j.B_y},
           {"P_x", j.P_x},
           {"P_y", j.P_y},
           {"Q_x", j.Q_x},
           {"Q_y", j.Q_y}}};
}

void scene_on_shears(const char* name, const Suspended& s, const Full_state& start, double until,
                     double fastest)
{
  Full_motion motion(s, start);
  scene_of_joints(name, until, fastest, s.beam.a / 12, true, [&](double t) {
    const Four at = motion.to(t).at;
    return joints(s.h, s.beam.a, s.beam.b, at.phi, at.omega, at.eta, at.theta);
  });
}

void scene_on_pivot(const char* name, const Balance<>& b, const State<>& start, double until)
{
  Motion motion(b, start);
  const double fastest = std::sqrt(std::max(b.lambda2, b.mu2));
  scene_of_joints(name, until, fastest, std::max(b.beta, 1.) / 12, false, [&](double t) {
    const Angles<> at = motion.to(t).at;
    return joints(0., b.beta, 1., 0., at.omega, at.eta, at.theta);
  });
}

}  // namespace balance
