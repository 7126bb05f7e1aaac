#include "process/laboratory/stability/profile_walls.h"

#include <cmath>
#include <numbers>

namespace diefill::process::laboratory {

namespace {

/// Triangles without area, as at the axis, face nowhere and are left out.
void add_triangle(engine::WallBodySpec& body, const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                  const Eigen::Vector3d& c) {
  if ((b - a).cross(c - a).norm() > 0) body.triangles.push_back({{a, b, c}});
}

void add_strip(engine::WallBodySpec& body, const Eigen::Vector3d& a, const Eigen::Vector3d& b,
               const Eigen::Vector3d& after_b, const Eigen::Vector3d& after_a) {
  add_triangle(body, a, b, after_b);
  add_triangle(body, a, after_b, after_a);
}

}  // namespace

void add_along_y(engine::WallBodySpec& body, const Profile& profile, double half) {
  const auto at = [](const Eigen::Vector2d& place, double y) {
    return Eigen::Vector3d(place[0], y, place[1]);
  };
  for (std::size_t k = 0; k + 1 < profile.size(); ++k)
    add_strip(body, at(profile[k], half), at(profile[k], -half), at(profile[k + 1], -half),
              at(profile[k + 1], half));
}

void add_about_z(engine::WallBodySpec& body, const Profile& profile) {
  constexpr int kParts = 48;
  const auto at = [](const Eigen::Vector2d& place, int part) {
    const double angle = 2 * std::numbers::pi * (part % kParts) / kParts;
    return Eigen::Vector3d(place[0] * std::cos(angle), place[0] * std::sin(angle), place[1]);
  };
  for (int part = 0; part < kParts; ++part)
    for (std::size_t k = 0; k + 1 < profile.size(); ++k)
      add_strip(body, at(profile[k], part + 1), at(profile[k], part), at(profile[k + 1], part),
                at(profile[k + 1], part + 1));
}

}  // namespace diefill::process::laboratory
