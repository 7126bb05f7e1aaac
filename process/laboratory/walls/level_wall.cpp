#include "process/laboratory/walls/level_wall.h"

#include <cmath>

#include "engine/limits/time_step.h"
#include "process/results/formatted.h"

namespace diefill::process::laboratory {

engine::WallBodySpec level_spheres(const SphereGrid& grid, double half_width,
                                   const std::function<bool(const Eigen::Vector3d&)>& wanted) {
  engine::WallBodySpec body;
  body.name = "spheres";
  body.sphere_radius = grid.radius;
  const double step = grid.spacing * grid.radius;
  const int count = static_cast<int>(std::ceil(half_width / step));
  for (int y = -count; y <= count; ++y)
    for (int x = -count; x <= count; ++x) {
      const Eigen::Vector3d centre(x * step, y * step, -grid.radius);
      if (wanted(centre)) body.centres.push_back(centre);
    }
  return body;
}

engine::WallBodySpec level_mesh(double half_width) {
  engine::WallBodySpec body;
  body.name = "mesh";
  const auto corner = [&](int x, int y) { return Eigen::Vector3d(x * half_width, y * half_width, 0); };
  body.triangles.push_back({{corner(-1, -1), corner(1, -1), corner(1, 1)}});
  body.triangles.push_back({{corner(-1, -1), corner(1, 1), corner(-1, 1)}});
  return body;
}

engine::SimulationSettings single_sphere(double damping_over_radius, double friction) {
  constexpr double kFastest = 1.0;  // m/s
  engine::SimulationSettings settings;
  settings.types = {{thesis_grain(ThesisGrain::sphere)}};
  engine::ContactParameters contact = elastic_contact();
  contact.damping = damping_over_radius * settings.shape().sphere_radius;
  contact.tangential = 1e6 * settings.shape().sphere_radius;
  contact.friction = friction;
  settings.contact = bierwisch_contact(contact, contact);
  settings.gravity.setZero();
  settings.time_step =
      engine::kDefaultTimeStepFraction *
      engine::critical_time_step(settings.shape(), engine::laws::bierwisch_law(elastic_contact()), kFastest);
  return settings;
}

std::string description(double radius_ratio) {
  return results::formatted("R_w = %.3g R", radius_ratio);
}

}  // namespace diefill::process::laboratory
