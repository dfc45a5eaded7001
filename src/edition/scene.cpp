// Scenes are curves, and what is drawn by them.

#include "edition/scene.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "edition/registry.hpp"

namespace edition
{
namespace drawn
{

Body rod(std::vector<Spot> joints, std::string colour)
{
  return {"rod", std::move(joints), 0, 0., std::move(colour)};
}

Body bob(Spot centre, double radius, std::string colour)
{
  return {"bob", {std::move(centre)}, radius, 0., std::move(colour)};
}

Body trail(Spot point, std::string colour)
{
  return {"trail", {std::move(point)}, 0, 0., std::move(colour)};
}

Body wheel(Spot centre, double radius, Moving turn, std::string colour)
{
  return {"wheel", {std::move(centre)}, radius, std::move(turn), std::move(colour)};
}

Body ground(double y, std::string colour)
{
  return {"ground", {{0., y}}, 0, 0., std::move(colour)};
}

}  // namespace drawn

void scene(const char* name, std::vector<Body> bodies, std::vector<std::string> columns,
           const Rule<void(Curve&)>& frames)
{
  const auto must_be_there = [&](const Moving& coordinate) {
    const auto* column = std::get_if<std::string>(&coordinate);
    if(column && std::find(columns.begin(), columns.end(), *column) == columns.end())
      throw std::logic_error(fmt::format("the scene {} has no column \"{}\"", name, *column));
  };
  for(const Body& b : bodies)
  {
    must_be_there(b.turn);
    for(const Spot& spot : b.at)
    {
      must_be_there(spot.x);
      must_be_there(spot.y);
    }
  }
  if(columns.empty() || columns.front() != "t")
    throw std::logic_error(fmt::format("the first column of the scene {} must be t", name));
  add_curve(name, std::move(columns), frames, section().wanted.scenes);
  section().said.scenes.push_back({name, std::move(bodies)});
}

}  // namespace edition
