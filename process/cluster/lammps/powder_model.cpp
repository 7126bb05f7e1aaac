#include "process/cluster/lammps/powder_model.h"

#include <algorithm>
#include <array>
#include <map>

#include "engine/simulation/simulation_parts.h"

namespace diefill::process::cluster {

namespace {

/// Over the radius of the smallest sphere: wide enough for some ten steps of powder that moves at a tenth of
/// a radius in a hundred steps.
constexpr double kSkin = 0.3;

void put_shape(Packet& message, const engine::ParticleType& type) {
  const engine::GrainShape& shape = type.shape;
  message.put(shape.sphere_radius);
  message.put(shape.sphere_offsets);
  message.put(shape.sphere_radii);
  message.put(shape.mass);
  for (const double moment : shape.inertia) message.put(moment);
  message.put(shape.solid_volume);
  message.put(shape.rotates);
  message.put(type.material);
}

engine::ParticleType take_shape(Packet& message) {
  engine::ParticleType type;
  engine::GrainShape& shape = type.shape;
  message.take(shape.sphere_radius);
  message.take(shape.sphere_offsets);
  message.take(shape.sphere_radii);
  message.take(shape.mass);
  for (double& moment : shape.inertia) message.take(moment);
  message.take(shape.solid_volume);
  message.take(shape.rotates);
  message.take(type.material);
  return type;
}

void put_laws(Packet& message, const engine::ContactLaws& laws) {
  message.put(laws.pairs.size());
  for (const auto& pair : laws.pairs) {
    message.put(pair.first);
    message.put(pair.second);
    message.put(pair.law);
  }
  message.put(laws.scaling);
}

engine::ContactLaws take_laws(Packet& message) {
  engine::ContactLaws laws;
  std::size_t count = 0;
  message.take(count);
  laws.pairs.resize(count);
  for (auto& pair : laws.pairs) {
    message.take(pair.first);
    message.take(pair.second);
    message.take(pair.law);
  }
  message.take(laws.scaling);
  return laws;
}

void put_air(Packet& message, const std::optional<engine::AirFlow>& air) {
  message.put(air.has_value());
  if (!air) return;
  message.put(air->body);
  message.put(std::vector<Eigen::Vector3d>{air->region.min(), air->region.max()});
  message.put(air->resistance);
}

std::optional<engine::AirFlow> take_air(Packet& message) {
  bool any = false;
  message.take(any);
  if (!any) return std::nullopt;
  engine::AirFlow air;
  message.take(air.body);
  std::vector<Eigen::Vector3d> corners;
  message.take(corners);
  air.region = {corners[0], corners[1]};
  message.take(air.resistance);
  return air;
}

void put_body(Packet& message, const engine::WallBody& body) {
  message.put(body.name());
  message.put(body.centres());
  message.put(body.sphere_radius());
  std::vector<Eigen::Vector3d> planes;
  for (const auto& plane : body.planes()) planes.insert(planes.end(), {plane.point, plane.normal});
  message.put(planes);
  std::vector<Eigen::Vector3d> corners;
  for (const auto& triangle : body.triangles())
    corners.insert(corners.end(), triangle.corner.begin(), triangle.corner.end());
  message.put(corners);
  message.put(body.contact_radius());
  message.put(body.material());
  message.put(body.mirror());
}

engine::WallBodySpec take_body(Packet& message) {
  engine::WallBodySpec body;
  message.take(body.name);
  message.take(body.centres);
  message.take(body.sphere_radius);
  std::vector<Eigen::Vector3d> planes;
  message.take(planes);
  for (std::size_t k = 0; k < planes.size(); k += 2) body.planes.push_back({planes[k], planes[k + 1]});
  std::vector<Eigen::Vector3d> corners;
  message.take(corners);
  for (std::size_t k = 0; k < corners.size(); k += 3)
    body.triangles.push_back({{corners[k], corners[k + 1], corners[k + 2]}});
  message.take(body.contact_radius);
  message.take(body.material);
  message.take(body.mirror);
  return body;
}

/// Where the wall spheres of `body` stand among `centres`, which are the same in another order; planes and
/// triangles stay in theirs.
std::vector<std::uint32_t> numbers_in(const std::vector<Eigen::Vector3d>& centres,
                                      const engine::WallBody& body) {
  std::map<std::array<double, 3>, std::vector<std::uint32_t>> number;
  for (std::uint32_t k = 0; k < centres.size(); ++k)
    number[{centres[k].x(), centres[k].y(), centres[k].z()}].push_back(k);
  std::vector<std::uint32_t> numbers;
  for (const auto& centre : body.centres()) {
    auto& same = number.at({centre.x(), centre.y(), centre.z()});
    numbers.push_back(same.back());
    same.pop_back();
  }
  for (std::uint32_t k = 0; numbers.size() < body.size(); ++k) numbers.push_back(k);
  return numbers;
}

}  // namespace

double PowderModel::reach(std::size_t type, std::size_t other) const {
  return types.shape(static_cast<engine::TypeNumber>(type)).bounding_radius() +
         types.shape(static_cast<engine::TypeNumber>(other)).bounding_radius() + law_range;
}

Packet model_message(const engine::Simulation& simulation) {
  const engine::SimulationSettings& settings = simulation.settings();
  Packet message;
  message.put(settings.types.size());
  for (const auto& type : settings.types) put_shape(message, type);
  put_laws(message, settings.contact);
  message.put(settings.lever_arm);
  for (const double component : settings.gravity) message.put(component);
  message.put(settings.air_viscosity);
  put_air(message, settings.air_flow);
  message.put(settings.time_step);
  message.put(settings.period);
  message.put(simulation.state().grain_loop->range());
  message.put(simulation.bodies().size());
  for (const auto& body : simulation.bodies()) put_body(message, body);
  return message;
}

PowderModel read_model(Packet& message) {
  engine::SimulationSettings settings;
  std::size_t count = 0;
  message.take(count);
  settings.types.clear();
  for (std::size_t k = 0; k < count; ++k) settings.types.push_back(take_shape(message));
  settings.contact = take_laws(message);
  message.take(settings.lever_arm);
  for (double& component : settings.gravity) message.take(component);
  message.take(settings.air_viscosity);
  settings.air_flow = take_air(message);
  message.take(settings.time_step);
  message.take(settings.period);
  PowderModel model{settings, engine::ParticleTypes(settings.types), {}, {}, 0, 0};
  model.skin = kSkin * model.types.smallest_sphere();
  message.take(model.law_range);
  message.take(count);
  for (std::size_t b = 0; b < count; ++b) {
    const engine::WallBodySpec spec = take_body(message);
    model.bodies.emplace_back(spec, 2 * model.types.largest_sphere() + spec.sphere_radius + model.skin);
    model.wall_number.push_back(numbers_in(spec.centres, model.bodies.back()));
  }
  return model;
}

}  // namespace diefill::process::cluster
