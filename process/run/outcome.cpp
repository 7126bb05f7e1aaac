#include "process/run/outcome.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "process/powder/material.h"
#include "process/results/formatted.h"
#include "process/setup/setup_findings.h"

namespace diefill::process {

namespace {

constexpr double kMuchLost = 0.02;      // share of the grains
constexpr double kUnfilled = 0.5;       // fill ratio
constexpr std::size_t kFewGrains = 50;  // in the cavity

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

/// Why a cavity counts as unfilled: by its fill ratio, and where that is not known, as no bed was left to
/// compare with, by the solid fraction that settled powder is expected to have.
void warn_about_unfilled_cavity(const Scene& scene, const results::FillResult& result,
                                std::vector<std::string>& lines) {
  const double ratio = figure(result, "fill_ratio");
  if (std::isfinite(ratio)) {
    if (ratio < kUnfilled)
      lines.push_back(
          kAlert +
          results::formatted("the cavity contains %.0f %% of the powder that would fill it", 100 * ratio));
    return;
  }
  const double expected = expected_solid_fraction(scene);
  const double guess = figure(result, "cavity_solid_fraction") / expected;
  if (guess < kUnfilled)
    lines.push_back(kAlert +
                    results::formatted("the cavity contains roughly %.0f %% of the powder that would fill "
                                       "it, by the solid fraction of %.2f "
                                       "that settled powder is expected to have; the fill ratio itself "
                                       "is unknown, as too little powder lies outside to compare with",
                                       100 * guess, expected));
}

void warn_about_few_grains(const results::FillResult& result, std::vector<std::string>& lines) {
  const auto& inside = result.solid_fraction.in_cavity;
  const auto grains = static_cast<std::size_t>(std::count(inside.begin(), inside.end(), 1));
  if (grains >= kFewGrains) return;
  lines.push_back(kAlert +
                  results::formatted("the cavity contains %zu model grain%s, fewer than %zu: its figures "
                                     "are not significant; use a smaller grain_diameter",
                                     grains, grains == 1 ? "" : "s", kFewGrains));
}

bool holds_powder(const ToolSpec& tool) {
  return tool.role == ToolRole::die || tool.role == ToolRole::shoe;
}

/// True for oscillations; a tool that turns on and on stays where it is, too.
bool shakes(const Step& step) {
  constexpr double kLong = 1e9;  // s, longer than any period
  return step.stays() && !step.turning_points(kLong).empty();
}

/// True if a step shakes a tool that also holds powder outside the cavity.
bool shakes_bed(const Scene& scene) {
  const auto holds = [&](const std::string& name) {
    return std::any_of(scene.tools.begin(), scene.tools.end(),
                       [&](const ToolSpec& tool) { return tool.name == name && holds_powder(tool); });
  };
  return std::any_of(scene.steps.begin(), scene.steps.end(), [&](const auto& step) {
    const std::vector<std::string> moved = step->tools();
    return shakes(*step) && std::any_of(moved.begin(), moved.end(), holds);
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
  if (result.cavity.volume > 0 && !scene.steps.empty()) {
    warn_about_unfilled_cavity(scene, result, lines);
    warn_about_few_grains(result, lines);
  }
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
