#include "process/laboratory/published/sawing/groove_measures.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/fluid/fluid_figures.h"

namespace diefill::process::laboratory::sawing {
namespace {

using engine::FluidSimulation;

constexpr double kMaxStretch = 2;  // r_c, of the groove's surface
constexpr int kEvery = 5;          // steps between samples
constexpr int kGrainWindow = 100;  // steps over which the stress in a grain is taken

}  // namespace

GrooveMeasures::GrooveMeasures(const GrooveCase& one, const GrooveParts& parts, GrooveSums& sums)
    : case_(one), parts_(parts), sums_(sums) {
  if (!sums.figures.stress.empty()) return;
  const double half = one.groove_radius * 0.5 * std::numbers::pi + one.top;
  const int count = 2 * static_cast<int>(std::ceil(half / kMaxStretch));
  for (int k = 0; k < count; ++k)
    sums.figures.stress.push_back({half * (2 * (k + 0.5) / count - 1), 2 * half / count, 0});
}

void GrooveMeasures::note_distance(const FluidSimulation& simulation) {
  GrooveFigures& figures = sums_.figures;
  figures.particle_steps += static_cast<double>(simulation.particles().size());
  if (simulation.state().step % kEvery != 0) return;
  figures.time.push_back(simulation.time());
  figures.distance.push_back(case_.groove_radius - case_.wire_radius +
                             simulation.solids().motion()[parts_.wire].centre.z());
}

void GrooveMeasures::sample(const FluidSimulation& simulation, int k) {
  add_grain_stress(simulation);
  if (k % kGrainWindow == 0) count_grain_stress();
  if (k % kEvery != 0) return;
  ++sums_.samples;
  sample_particles(simulation);
  sums_.figures.temperature += engine::fluid_temperature(simulation);
  sums_.figures.mean_distance += sums_.figures.distance.back();
}

std::size_t GrooveMeasures::stretch_of(const SurfacePlace& at) const {
  const std::vector<GrooveStress>& stress = sums_.figures.stress;
  const double from = stress.front().place - 0.5 * stress.front().width;
  return std::min(static_cast<std::size_t>((at.along - from) / stress[0].width), stress.size() - 1);
}

void GrooveMeasures::sample_particles(const FluidSimulation& simulation) {
  const engine::Grains& particles = simulation.particles();
  std::vector<GrooveStress>& stress = sums_.figures.stress;
  for (std::size_t k = 0; k < particles.size(); ++k) {
    const std::uint32_t set = simulation.solids().set_of(particles.id[k]);
    if (set == engine::RigidSets::kFluid) {
      add_speed(particles.position[k], particles.velocity[k].y());
    } else if (set == parts_.ingot) {
      const SurfacePlace& at = parts_.surface[particles.id[k] - parts_.first_of_ingot];
      stress[stretch_of(at)].stress += particles.force[k].dot(at.into);
    } else if (set == parts_.lid) {
      sums_.lid_force += particles.force[k].z();
    }
  }
}

/// Below the wire's axis, where groove and wire are round about one axis if the wire has not moved.
void GrooveMeasures::add_speed(const Eigen::Vector3d& place, double speed) {
  if (place.z() > 0) return;
  constexpr double kLayer = 0.25;
  const double from = case_.wire_radius, to = case_.groove_radius, r = std::hypot(place.x(), place.z());
  const auto layers = static_cast<std::size_t>(std::lround((to - from) / kLayer));
  sums_.speed.resize(layers), sums_.count.resize(layers);
  const double layer = (r - from) / (to - from) * static_cast<double>(layers);
  if (layer < 0 || layer >= static_cast<double>(layers)) return;
  sums_.speed[static_cast<std::size_t>(layer)] += speed;
  sums_.count[static_cast<std::size_t>(layer)] += 1;
}

void GrooveMeasures::add_grain_stress(const FluidSimulation& simulation) {
  const FilledSlurry& slurry = parts_.slurry;
  if (slurry.grain_size.empty()) return;
  const auto all = engine::solid_pressure_times_volume(simulation);
  sums_.grain_pressure.resize(slurry.grain_size.size());
  for (std::size_t g = 0; g < sums_.grain_pressure.size(); ++g) {
    const std::size_t s = slurry.first_grain + g;
    sums_.grain_pressure[g] += all[s].trace() / (3 * simulation.solids().spec(s).shape.solid_volume);
  }
}

void GrooveMeasures::count_grain_stress() {
  constexpr double kLow = 5, kHigh = 25;  // N/mm^2
  std::vector<GrainStress>& grains = sums_.figures.grains;
  for (std::size_t g = 0; g < sums_.grain_pressure.size(); ++g) {
    const double size = parts_.slurry.grain_size[g];
    auto found =
        std::find_if(grains.begin(), grains.end(), [&](const GrainStress& one) { return one.size == size; });
    if (found == grains.end()) found = grains.insert(found, GrainStress{.size = size});
    const double stress = ReducedUnits::pressure_of_process * sums_.grain_pressure[g] / kGrainWindow;
    (stress <= kLow ? found->low : stress <= kHigh ? found->middle : found->high) += 1;
    sums_.grain_pressure[g] = 0;
  }
}

/// A slice half a unit to either side of the middle.
void GrooveMeasures::take_section(const FluidSimulation& simulation) {
  const engine::Grains& particles = simulation.particles();
  using Part = SectionPoint::Part;
  for (std::size_t k = 0; k < particles.size(); ++k) {
    const Eigen::Vector3d& place = particles.position[k];
    if (std::abs(place.y()) > 0.5) continue;
    const std::uint32_t set = simulation.solids().set_of(particles.id[k]);
    const Part part = set == engine::RigidSets::kFluid   ? Part::fluid
                      : simulation.solids().is_tool(set) ? Part::tool
                                                         : Part::grain;
    sums_.figures.section.push_back({part, place.x(), place.z()});
  }
}

/// Over the area of the stretch's particles: a stretch holds some more or less than its width asks for.
void GrooveMeasures::conclude_stress() {
  std::vector<GrooveStress>& stress = sums_.figures.stress;
  std::vector<double> area(stress.size());
  for (const SurfacePlace& at : parts_.surface) area[stretch_of(at)] += at.area;
  const double lid = sums_.lid_force / sums_.samples / (2 * case_.groove_radius * case_.length);
  for (std::size_t k = 0; k < stress.size(); ++k) {
    stress[k].stress = stress[k].stress / sums_.samples / area[k] - lid;
    stress[k].width = area[k] / case_.length;
  }
}

void GrooveMeasures::conclude(const FluidSimulation& simulation) {
  GrooveFigures& figures = sums_.figures;
  take_section(simulation);
  const double width = case_.groove_radius - case_.wire_radius;
  const auto layers = static_cast<double>(sums_.speed.size());
  for (std::size_t k = 0; k < sums_.speed.size(); ++k)
    if (sums_.count[k] > 0)
      figures.gap.push_back({case_.wire_radius + width * (static_cast<double>(k) + 0.5) / layers,
                             sums_.speed[k] / sums_.count[k]});
  conclude_stress();
  for (GrainStress& one : figures.grains) {
    const double all = one.low + one.middle + one.high;
    one.low /= all, one.middle /= all, one.high /= all;
  }
  figures.temperature /= sums_.samples;
  figures.mean_distance /= sums_.samples;
  figures.solids = parts_.slurry.solids;
}

}  // namespace diefill::process::laboratory::sawing
