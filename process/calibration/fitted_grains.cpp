#include "process/calibration/fitted_grains.h"

#include <algorithm>

#include "process/input/scene_error.h"
#include "process/input/units.h"
#include "process/results/word_list.h"
#include "process/scene/powder/grain_models.h"

namespace diefill::process::calibration {
namespace {

std::string grains_of(const Scene& scene) {
  const std::string grains =
      scene.powder.clump ? "clumps" : std::string("grain model ") + name_of(scene.powder.model);
  return grains + ", d = " + number_text(1e3 * scene.powder.grain_diameter) + " mm, " +
         (scene.walls.kind == WallKind::mesh
              ? "mesh walls"
              : "wall spheres of " + number_text(1e3 * scene.walls.sphere_radius) + " mm, spacing " +
                    number_text(scene.walls.spacing)) +
         (scene.contact ? ", [contact] of the powder file"
                        : ", reduced modulus " + number_text(1e-6 * scene.powder.reduced_modulus) + " MPa");
}

void add(std::vector<FittedGrains>& all, const std::string& text, const std::string& measurement) {
  auto found =
      std::find_if(all.begin(), all.end(), [&](const FittedGrains& one) { return one.text == text; });
  if (found == all.end()) found = all.insert(all.end(), FittedGrains{text, {}});
  if (std::find(found->measurements.begin(), found->measurements.end(), measurement) ==
      found->measurements.end())
    found->measurements.push_back(measurement);
}

std::string with_measurements(const FittedGrains& grains) {
  constexpr std::size_t kMostNamed = 4;
  std::vector<std::string> names;
  for (const std::string& name : grains.measurements) names.push_back('"' + name + '"');
  return grains.text + " (" + results::comma_list(names, kMostNamed) + ')';
}

}  // namespace

std::vector<FittedGrains> fitted_grains(const CalibrationPlan& plan, const Fit& fit) {
  const std::vector<double> best(fit.region.best.begin(), fit.region.best.end());
  std::vector<FittedGrains> all;
  for (const std::size_t m : fit.measurement) {
    const Measurement& measurement = plan.measurements[m];
    for (const MeasurementRun& run : measurement.runs) {
      try {
        add(all, grains_of(scene_at(plan, run, best)), measurement.name);
      } catch (const SceneError&) {
        continue;  // this scene cannot have these parameters, so that none of its runs has them
      }
    }
  }
  return all;
}

std::string text_of(const std::vector<FittedGrains>& grains) {
  if (grains.size() == 1) return grains.front().text;
  std::string text;
  for (const FittedGrains& one : grains) text += (text.empty() ? "" : "; ") + with_measurements(one);
  return text;
}

std::string differing_grains(const std::vector<FittedGrains>& grains) {
  if (grains.size() < 2) return {};
  return "the measurements were fitted with different grains, walls or stiffness: " + text_of(grains) +
         "; powder.toml has the first of these alone, to which runs with the powder are compared";
}

}  // namespace diefill::process::calibration
