#include "process/laboratory/published/sawing/groove_film.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "process/results/instant_powder.h"
#include "process/results/storage/result_file.h"

namespace diefill::process::laboratory::sawing {
namespace {

using results::FillResult;
using results::Instant;
using results::ToolState;

constexpr double kMetre = 1e-6 * ReducedUnits::micrometres;       // of the process, r_c
constexpr double kSpeedUnit = ReducedUnits::velocity_of_process;  // m/s
constexpr double kSecond = kMetre / kSpeedUnit;                   // of the process, unit of time
constexpr double kWallThickness = 3;                              // r_c, drawn of the ingot
constexpr double kRounding = 1e-9;                                // m, of places: files are smaller

Eigen::Vector3d metres(const Eigen::Vector3d& place) {
  return kRounding * (kMetre / kRounding * place).array().round().matrix();
}

/// Adds a strip between a curve in x and z and its like at the other end along y.
class Extrusion {
 public:
  explicit Extrusion(double length) : half_(0.5 * length) {}

  /// Around a closed outline, counter-clockwise seen from -y, with `triangles` of its numbers as both ends.
  ToolState tool(const std::string& name, const std::vector<Eigen::Vector2d>& outline,
                 const std::vector<Eigen::Vector3i>& triangles) const {
    ToolState tool;
    tool.name = name;
    tool.role = "die";
    const auto count = static_cast<int>(outline.size());
    for (const double y : {-half_, half_})
      for (const auto& point : outline) tool.vertices.push_back(metres({point.x(), y, point.y()}));
    for (const auto& end : triangles) {
      tool.triangles.emplace_back(end);
      tool.triangles.emplace_back(count + end[0], count + end[2], count + end[1]);
    }
    for (int k = 0; k < count; ++k) {
      const int next = (k + 1) % count;
      tool.triangles.emplace_back(k, count + k, next);
      tool.triangles.emplace_back(next, count + k, count + next);
    }
    return tool;
  }

 private:
  double half_;
};

constexpr int kArcs = 72;  // corners of a half circle

ToolState wire_mesh(const GrooveCase& one, double height) {
  std::vector<Eigen::Vector2d> outline;
  std::vector<Eigen::Vector3i> ends;
  for (int k = 0; k < 2 * kArcs; ++k) {
    const double angle = std::numbers::pi * k / kArcs;
    outline.emplace_back(one.wire_radius * std::cos(angle), height + one.wire_radius * std::sin(angle));
    if (k > 1) ends.emplace_back(0, k - 1, k);
  }
  return Extrusion(one.length).tool("wire", outline, ends);
}

ToolState ingot_mesh(const GrooveCase& one) {
  std::vector<Eigen::Vector2d> inside, outside;
  const double wide = one.groove_radius, far = wide + kWallThickness;
  inside.emplace_back(-wide, one.top);
  outside.emplace_back(-far, one.top);
  for (int k = 0; k <= kArcs; ++k) {
    const double angle = std::numbers::pi * (1 + static_cast<double>(k) / kArcs);
    const Eigen::Vector2d out(std::cos(angle), std::sin(angle));
    inside.emplace_back(wide * out);
    outside.emplace_back(far * out);
  }
  inside.emplace_back(wide, one.top);
  outside.emplace_back(far, one.top);
  std::vector<Eigen::Vector2d> outline = outside;
  outline.insert(outline.end(), inside.rbegin(), inside.rend());
  std::vector<Eigen::Vector3i> ends;
  const auto all = static_cast<int>(outline.size());
  for (int k = 0; k + 1 < static_cast<int>(inside.size()); ++k) {
    ends.emplace_back(k, k + 1, all - 1 - k);
    ends.emplace_back(k + 1, all - 2 - k, all - 1 - k);
  }
  return Extrusion(one.length).tool("ingot", outline, ends);
}

void name_powder(FillResult& result, const FinishedGroove& finished) {
  const std::vector<double> sizes = SlurryMixture().sizes;
  results::PowderState& powder = result.powder;
  constexpr double kSiliconCarbide = 3210;  // kg/m^3
  const double radius = 0.5 * kSpacing * kMetre, volume = std::pow(kSpacing * kMetre, 3);
  powder.sphere_radius = radius;
  powder.grain_diameter = sizes.back() * kMetre;
  powder.grain_solid_volume = volume;
  powder.grain_mass = kSiliconCarbide * volume;
  powder.sphere_offsets = {Eigen::Vector3d::Zero()};
  powder.period = {0, finished.shape.length * kMetre, 0};
  for (const double size : sizes) {
    powder.kinds.diameter.push_back(size * kMetre);
    powder.kinds.sphere_radius.push_back(radius);
    powder.kinds.mass.push_back(kSiliconCarbide * volume);
    powder.kinds.solid_volume.push_back(volume);
    powder.kinds.material.push_back("silicon carbide");
  }
}

}  // namespace

Instant instant_of(const engine::FluidSimulation& simulation, const GrooveParts& parts) {
  const engine::Grains& particles = simulation.particles();
  const std::vector<double> sizes = SlurryMixture().sizes;
  const FilledSlurry& slurry = parts.slurry;
  std::vector<std::pair<std::uint64_t, std::size_t>> order;  // of the particles, by number
  for (std::size_t k = 0; k < particles.size(); ++k) {
    const std::uint32_t set = simulation.solids().set_of(particles.id[k]);
    if (set != engine::RigidSets::kFluid && set >= slurry.first_grain) order.emplace_back(particles.id[k], k);
  }
  std::sort(order.begin(), order.end());
  // Between searches particles may be beyond the period's border.
  const double length = simulation.settings().period[1].value();
  const auto in_period = [&](Eigen::Vector3d place) {
    place.y() -= length * std::round(place.y() / length);
    return place;
  };
  Instant instant;
  instant.time = kSecond * simulation.time();
  for (const auto& [id, k] : order) {
    const double size = slurry.grain_size[simulation.solids().set_of(id) - slurry.first_grain];
    instant.id.push_back(id);
    instant.position.push_back(metres(in_period(particles.position[k])));
    instant.orientation.emplace_back(1, 0, 0, 0);
    instant.velocity.push_back(1e-2 * (1e2 * kSpeedUnit * particles.velocity[k]).array().round().matrix());
    instant.kind.push_back(
        static_cast<std::uint8_t>(std::find(sizes.begin(), sizes.end(), size) - sizes.begin()));
  }
  instant.tool_orientation.assign(2, {1, 0, 0, 0});
  instant.tool_displacement = {metres({0, 0, simulation.solids().motion()[parts.wire].centre.z()}),
                               Eigen::Vector3d::Zero()};
  return instant;
}

FillResult film_of(const FinishedGroove& finished, const std::vector<Instant>& instants) {
  const GrooveCase& one = finished.shape;
  FillResult result;
  result.title = "Grains between wire and ingot";
  char text[160];
  std::snprintf(text, sizeof text, "wire at %.3g m/s, %.3g N/mm2",
                one.speed * ReducedUnits::velocity_of_process,
                one.pressure * ReducedUnits::pressure_of_process);
  result.strategy = text;
  result.powder_name = "silicon carbide in a DPD fluid";
  result.seed = finished.seed;
  name_powder(result, finished);
  const Instant end = instant_of(finished.simulation, finished.parts);
  result.powder = results::powder_at(result.powder, end);
  result.powder.angular_velocity.assign(end.id.size(), Eigen::Vector3d::Zero());
  result.tools = {wire_mesh(one, end.tool_displacement[0].z() / kMetre), ingot_mesh(one)};
  result.instants = instants;
  if (!instants.empty() && instants.back().time >= end.time) result.instants.pop_back();
  for (Instant& instant : result.instants) instant.tool_displacement[0] -= end.tool_displacement[0];
  result.cavity.lower_corner = metres({-one.groove_radius, -0.5 * one.length, -one.groove_radius});
  result.cavity.upper_corner = metres({one.groove_radius, 0.5 * one.length, one.top});
  result.cavity.narrowest_width = (one.groove_radius - one.wire_radius) * kMetre;
  return result;
}

void write_film(const std::filesystem::path& folder, const FinishedGroove& finished,
                const std::vector<Instant>& instants) {
  results::write_results(folder, film_of(finished, instants));
}

}  // namespace diefill::process::laboratory::sawing
