#include "process/run/figures/filling_figures.h"

#include <algorithm>
#include <limits>

#include "process/measure/measure.h"
#include "process/scene/powder/powder_presets.h"

namespace diefill::process {
namespace {

/// m/s: of the shoe while it moves, the median over its steps, which leaves out how it starts and stops; NaN
/// where no shoe moves.
double shoe_speed(const Scene& scene) {
  constexpr int kInstants = 1000;
  std::vector<double> speeds;
  for (const auto& step : scene.steps) {
    const auto moved = step->tools();
    const bool shoe = std::any_of(scene.tools.begin(), scene.tools.end(), [&](const ToolSpec& tool) {
      return tool.role == ToolRole::shoe && std::find(moved.begin(), moved.end(), tool.name) != moved.end();
    });
    if (!shoe || !step->duration()) continue;
    for (int n = 1; n < kInstants; ++n) {
      const double speed = step->motion(*step->duration() * n / kInstants).velocity.head<2>().norm();
      if (speed > 0) speeds.push_back(speed);
    }
  }
  if (speeds.empty()) return std::numeric_limits<double>::quiet_NaN();
  const auto middle = speeds.begin() + static_cast<std::ptrdiff_t>(speeds.size() / 2);
  std::nth_element(speeds.begin(), middle, speeds.end());
  return *middle;
}

double model_density(const results::PowderState& powder) {
  return powder.grain_mass / powder.grain_solid_volume;
}

}  // namespace

void add_powder_figures(results::FillResult& result, const Scene& scene, const PowderBed& bed) {
  result.figures["shoe_speed_m_s"] = shoe_speed(scene);
  result.figures["coarse_graining_factor"] = coarse_graining_factor(scene.powder);
  result.figures["model_apparent_density_kg_m3"] = bed.solid_fraction * model_density(result.powder);
}

void add_filling_figures(results::FillResult& result, const Scene& scene, const PowderBed& bed) {
  if (!(result.cavity.volume > 0)) return;
  RealPowder powder{scene.powder.apparent_density, preset_solid_density(scene.powder)};
  if (!(powder.solid_density > 0)) powder.solid_density = model_density(result.powder);
  add_real_mass(result, powder, bed);
  for (const auto& profile : result.profiles) {
    if (profile.quantity == "filled fraction")
      result.figures["azimuthal_variation"] = relative_range(profile);
    if (profile.quantity == "solid fraction" && profile.x_name == "height")
      result.figures["axial_variation"] = relative_range(profile);
  }
}

}  // namespace diefill::process
