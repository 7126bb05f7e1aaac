#include "process/plan/expected_error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "process/plan/grain_size_trends.h"
#include "process/plan/setting.h"
#include "process/results/formatted.h"
#include "process/results/word_list.h"
#include "process/scene/powder/unchanged_preset.h"

namespace diefill::process::plan {

namespace {

/// Solid fraction of powder settled from a shoe, as in README.md, "How far to trust it": found here with
/// grains enlarged by `factor` (first figure: volume of grains over that of their cells), and published with
/// grains of the calibrated size (Bierwisch 2009, Table 4.4).
struct SettledPowder {
  const char* preset;
  double factor, found, published;
};

constexpr std::array<SettledPowder, 4> kSettled = {{{"ASC100.29 initial A", 4, 0.5991, 0.59},
                                                    {"ASC100.29 initial D", 4, 0.3898, 0.38},
                                                    {"ASC100.29 D1", 4, 0.2844, 0.30},
                                                    {"ASC100.29 D2", 4, 0.3313, 0.32}}};

// Grains finer than those that were run settle like them: D1 at 0.2813 with d = 0.47 mm and at 0.2845 with
// four times that (process/laboratory/README.md).
constexpr double kSameFactor = 0.05;  // relative

/// Of the published bed; nothing where there is none.
std::optional<ExpectedError> error_of_bed(const PowderSpec& powder, double grain_diameter, double width) {
  // Beyond a third of the width grains wedge, which settled powder does not show.
  if (width > 0 && grain_diameter > kCoarsestToDecide * width * (1 + 1e-9)) return std::nullopt;
  const double factor = grain_diameter / calibrated_diameter(powder);
  for (const auto& row : kSettled)
    if (powder.name == row.preset && factor < (1 + kSameFactor) * row.factor && factor > 1 - kSameFactor)
      return ExpectedError{"settled solid fraction", std::abs(row.found - row.published) / row.published, 0,
                           "README.md, How far to trust it (Bierwisch 2009, Table 4.4)"};
  return std::nullopt;
}

using Trends = std::vector<GrainSizeTrend>;

constexpr double kSameShare = 1.03;  // d/b up to this many times one that was run counts as that one

bool was_measured(const Trends& all, const std::string& powder, const std::string& figure) {
  return std::any_of(all.begin(), all.end(),
                     [&](const auto& trend) { return powder == trend.powder && figure == trend.figure; });
}

/// Names in the order in which they first stand there, "a, b and c".
template <class NameOf>
std::string names(const std::vector<const GrainSizeTrend*>& trends, NameOf name_of) {
  std::vector<std::string> found;
  for (const auto* trend : trends)
    if (std::find(found.begin(), found.end(), name_of(*trend)) == found.end())
      found.push_back(name_of(*trend));
  return results::and_list(found);
}

/// The trends of a figure: of the powder itself where it was measured, else of all.
std::vector<const GrainSizeTrend*> trends_of(const Trends& all, const std::string& powder,
                                             const std::string& figure) {
  const bool own = was_measured(all, powder, figure);
  std::vector<const GrainSizeTrend*> trends;
  for (const auto& trend : all)
    if (trend.figure == figure && (!own || trend.powder == powder)) trends.push_back(&trend);
  return trends;
}

double coarsest_of(const std::vector<const GrainSizeTrend*>& trends) {
  double coarsest = 0;
  for (const auto* trend : trends) coarsest = std::max(coarsest, trend->coarsest);
  return coarsest;
}

double error_at(const GrainSizeTrend& trend, double share) {
  return std::hypot(trend.slope, trend.slope_error) * share;
}

std::string extrapolation_text(double beyond) {
  return results::formatted("extrapolated beyond d/b = %.2g", beyond);
}

/// The largest error that these trends of a figure give with grains of `share` of the length that matters.
ExpectedError error_of_size(const std::vector<const GrainSizeTrend*>& trends, const std::string& table,
                            const std::string& powder, double share) {
  const GrainSizeTrend& worst = **std::max_element(
      trends.begin(), trends.end(),
      [&](const auto* a, const auto* b) { return error_at(*a, share) < error_at(*b, share); });
  ExpectedError found{worst.figure, error_at(worst, share), 0, {}};
  if (share > kSameShare * worst.coarsest) found.extrapolated_beyond = worst.coarsest;
  int runs = 0;
  for (const auto* trend : trends) {
    runs += trend->runs;
    found.scatter = std::max(found.scatter, trend->scatter);
  }
  found.source = std::to_string(runs) + " runs of " + names(trends, [](const auto& t) { return t.powder; }) +
                 " in " + names(trends, [](const auto& t) { return t.scene; }) +
                 (trends.front()->powder == powder ? "" : ", another powder") +
                 (found.extrapolated_beyond > 0 ? ", " + extrapolation_text(found.extrapolated_beyond) : "") +
                 " (process/plan/" + table + ")";
  return found;
}

/// Adds the errors of figures that depend on the same length, up to the coarsest grains that were run of any.
void add_errors(const Trends& all, const std::string& table, const std::string& powder, double share,
                const std::vector<std::string>& figures, std::vector<ExpectedError>& errors) {
  std::vector<std::vector<const GrainSizeTrend*>> trends;
  double coarsest = 0;
  for (const auto& figure : figures) {
    trends.push_back(trends_of(all, powder, figure));
    coarsest = std::max(coarsest, coarsest_of(trends.back()));
  }
  if (share > kSameShare * coarsest) return;
  for (const auto& of_figure : trends)
    if (!of_figure.empty()) errors.push_back(error_of_size(of_figure, table, powder, share));
}

/// Errors due to the grain size, in the order in which they are reported.
std::vector<ExpectedError> errors_of_size(const std::string& powder, double diameter,
                                          const SceneLengths& lengths) {
  std::vector<ExpectedError> errors;
  if (lengths.cavity > 0) {
    add_errors(grain_size_trends(), "grain_size_errors.csv", powder, diameter / lengths.cavity,
               {"mass of a full cavity", "mean solid fraction", "unevenness"}, errors);
    return errors;
  }
  const auto open = [&](double length, const char* figure) {
    if (length > 0)
      add_errors(open_scene_trends(), "open_scene_errors.csv", powder, diameter / length, {figure}, errors);
  };
  open(lengths.opening, "mass through the opening");
  if (lengths.opening > 0) return errors;
  open(lengths.depth, "bulk solid fraction");
  if (lengths.heap) open(lengths.depth, "slope of a heap");
  return errors;
}

}  // namespace

SceneLengths lengths_of(const Scene& scene, const Tooling& tooling, double opening) {
  return {tooling.all_cavities().narrowest_width, opening, scene.pour.fill_height,
          !scene.measure.heaps.empty()};
}

std::vector<ExpectedError> expected_errors(const PowderSpec& powder, double grain_diameter,
                                           const SceneLengths& lengths) {
  // A preset with other parameters is a powder that was not measured.
  if (!is_unchanged_preset(powder)) return errors_of_size({}, grain_diameter, lengths);
  auto errors = errors_of_size(powder.name, grain_diameter, lengths);
  if (auto error = error_of_bed(powder, grain_diameter, lengths.cavity)) errors.push_back(*error);
  return errors;
}

const ExpectedError* largest(const std::vector<ExpectedError>& errors) {
  const auto found = std::max_element(errors.begin(), errors.end(),
                                      [](const auto& a, const auto& b) { return a.error < b.error; });
  return found == errors.end() ? nullptr : &*found;
}

std::string text_of_errors(const std::vector<ExpectedError>& errors) {
  std::string text;
  for (const auto& error : errors) {
    std::string known = error.scatter > 0 ? results::formatted("scatter %.2g %%", 100 * error.scatter) : "";
    if (error.extrapolated_beyond > 0)
      known += (known.empty() ? "" : ", ") + extrapolation_text(error.extrapolated_beyond);
    text += (text.empty() ? "" : ", ") + error.quantity + results::formatted(" %.2g %%", 100 * error.error) +
            (known.empty() ? "" : " (" + known + ")");
  }
  return text;
}

}  // namespace diefill::process::plan
