#include "process/scene/powder/other_powders.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "process/scene/scene.h"

namespace diefill::process {

PowderSpec mean_powder(const PowderSpec& first, const PowderSpec& second) {
  const auto mean = [](double a, double b) { return 0.5 * (a + b); };
  PowderSpec powder = first;
  powder.label = first.label + " with " + second.label;
  powder.reduced_modulus = 2 / (1 / first.reduced_modulus + 1 / second.reduced_modulus);
  powder.work_of_adhesion = std::sqrt(first.work_of_adhesion * second.work_of_adhesion);
  powder.friction = mean(first.friction, second.friction);
  powder.damping_over_radius = mean(first.damping_over_radius, second.damping_over_radius);
  powder.tangential_over_radius = mean(first.tangential_over_radius, second.tangential_over_radius);
  powder.rolling_friction = std::min(first.rolling_friction, second.rolling_friction);
  powder.grain_diameter *= std::sqrt(coarse_graining_factor(second) / coarse_graining_factor(first));
  powder.sizes.clear();
  return powder;
}

std::string amount_text(const Scene& scene, const OtherPowder& other) {
  double layers = 0;
  for (const PourLayer& layer : scene.pour.layers)
    if (powder_of(scene, layer.powder).label == other.powder.label) layers += layer.share;
  char text[160];
  const double share = scene.pour.layers.empty() ? other.share : layers;
  std::snprintf(text, sizeof text, "%.3g %% %s, ", 100 * share,
                scene.pour.layers.empty() ? "by mass" : "of the fill height");
  std::string words = text;
  if (!other.powder.sizes_text.empty()) return words + other.powder.sizes_text;
  std::snprintf(text, sizeof text, "grains of d = %.4g mm", 1e3 * other.powder.grain_diameter);
  return words + text;
}

const PowderSpec& powder_of(const Scene& scene, std::size_t number) {
  return number == 0 ? scene.powder : scene.other_powders.at(number - 1).powder;
}

std::string powder_names(const Scene& scene) {
  std::string names = scene.powder.label;
  for (const auto& other : scene.other_powders) names += ", " + other.powder.label;
  return names;
}

std::optional<std::size_t> powder_named(const Scene& scene, const std::string& name) {
  for (std::size_t k = 0; k <= scene.other_powders.size(); ++k)
    if (powder_of(scene, k).label == name) return k;
  return std::nullopt;
}

double smallest_grain(const Scene& scene) {
  double size = smallest_grain(scene.powder);
  for (const auto& other : scene.other_powders) size = std::min(size, smallest_grain(other.powder));
  return size;
}

double largest_grain(const Scene& scene) {
  double size = largest_grain(scene.powder);
  for (const auto& other : scene.other_powders) size = std::max(size, largest_grain(other.powder));
  return size;
}

std::vector<double> grain_diameters(const Scene& scene) {
  std::vector<double> diameters = grain_diameters(scene.powder);
  for (const auto& other : scene.other_powders) {
    const auto its = grain_diameters(other.powder);
    diameters.insert(diameters.end(), its.begin(), its.end());
  }
  return diameters;
}

void enlarge(Scene& scene, double factor) {
  enlarge(scene.powder, factor);
  for (auto& other : scene.other_powders) enlarge(other.powder, factor);
  for (auto& pair : scene.powder_pairs) enlarge(pair.powder, factor);
}

}  // namespace diefill::process
