#include "process/run/outcome.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "process/setup/setup_findings.h"

namespace diefill::process {

namespace {

constexpr double kMuchLost = 0.02;       // share of the grains
constexpr double kUnfilled = 0.5;        // fill ratio
constexpr double kFewGrains = 50;        // in the cavity
constexpr double kUsualFraction = 0.35;  // solid fraction where nothing is known

double figure(const results::FillResult& result, const std::string& name) {
  const auto found = result.figures.find(name);
  return found == result.figures.end() ? std::nan("") : found->second;
}

bool clears(const Scene& scene) {
  return std::any_of(scene.steps.begin(), scene.steps.end(),
                     [](const auto& step) { return step->removal() != nullptr; });
}

void warn_about_lost_grains(const Scene& scene, const results::FillResult& result,
                            std::vector<std::string>& lines) {
  const double left = figure(result, "grains_left"), share = figure(result, "grains_left_share");
  if (!(left > 0)) return;
  char text[300];
  std::snprintf(text, sizeof text, "%.0f of %.0f grains (%.3g %%, %.3g g) left the tools%s", left,
                left / share, 100 * share, 1e3 * figure(result, "mass_left_kg"),
                clears(scene) ? ", including those cleared away" : "");
  const bool meant = clears(scene) || !(result.cavity.volume > 0);
  lines.push_back((share > kMuchLost && !meant ? kAlert : std::string()) + text);
}

/// Powder in the cavity over that of a full one; as the estimate of the settled solid fraction has it where
/// no bed was left to compare with.
double filled_share(const Scene& scene, const results::FillResult& result) {
  const double ratio = figure(result, "fill_ratio");
  if (std::isfinite(ratio)) return ratio;
  const double fraction = scene.pour.solid_fraction > 0 ? scene.pour.solid_fraction : kUsualFraction;
  const double density = result.powder.grain_mass / result.powder.grain_solid_volume;
  return figure(result, "filled_mass_kg") / (result.cavity.volume * fraction * density);
}

void warn_about_unfilled_cavity(const Scene& scene, const results::FillResult& result,
                                std::vector<std::string>& lines) {
  if (!(result.cavity.volume > 0) || scene.steps.empty()) return;
  char text[200];
  const double share = filled_share(scene, result);
  if (share < kUnfilled) {
    std::snprintf(text, sizeof text, "the cavity contains %.0f %% of the powder that would fill it",
                  100 * share);
    lines.push_back(kAlert + std::string(text));
  }
  const double grains = figure(result, "filled_mass_kg") / result.powder.grain_mass;
  if (grains >= kFewGrains) return;
  std::snprintf(text, sizeof text,
                "the cavity contains about %.0f model grains, fewer than %.0f: its figures are not "
                "significant; use a smaller "
                "grain_diameter",
                grains, kFewGrains);
  lines.push_back(kAlert + std::string(text));
}

bool holds_powder(const ToolSpec& tool) {
  return tool.role == ToolRole::die || tool.role == ToolRole::shoe;
}

/// True if a step shakes a tool that also holds powder outside the cavity.
bool shakes_bed(const Scene& scene) {
  const auto holds = [&](const std::string& name) {
    return std::any_of(scene.tools.begin(), scene.tools.end(),
                       [&](const ToolSpec& tool) { return tool.name == name && holds_powder(tool); });
  };
  return std::any_of(scene.steps.begin(), scene.steps.end(), [&](const auto& step) {
    const std::vector<std::string> moved = step->tools();
    return step->stays() && std::any_of(moved.begin(), moved.end(), holds);
  });
}

void warn_about_shaken_bed(const Scene& scene, const results::FillResult& result,
                           std::vector<std::string>& lines) {
  if (!std::isfinite(figure(result, "fill_ratio")) || !shakes_bed(scene)) return;
  lines.emplace_back(
      "shaking also packed the powder outside the cavity, which the fill ratio refers to; compare ways of "
      "shaking by filled mass of model powder or mean solid fraction");
}

}  // namespace

std::vector<std::string> outcome_text(const Scene& scene, const results::FillResult& result) {
  std::vector<std::string> lines;
  warn_about_lost_grains(scene, result, lines);
  warn_about_unfilled_cavity(scene, result, lines);
  warn_about_shaken_bed(scene, result, lines);
  return lines;
}

std::vector<std::string> alerts_of(const std::vector<std::string>& warnings) {
  const std::string alert = kAlert;
  std::vector<std::string> alerts;
  for (const auto& warning : warnings)
    if (warning.starts_with(alert)) alerts.push_back(warning.substr(alert.size()));
  return alerts;
}

}  // namespace diefill::process
