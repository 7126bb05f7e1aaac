#include "process/measure/figures/enough_grains.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "process/measure/figures/counted_grains.h"
#include "process/results/no_value.h"

namespace diefill::process {
namespace {

constexpr const char* kDeep = "two diameters below the surface in the cavity";
constexpr std::size_t kSectors = 12, kThirds = 3;
constexpr std::size_t kHarmonicTerms = 5, kTravelTerms = 3;  // coefficients that are fitted

/// A figure, the grains it stands on, and how many parts of it need kMinGrains each.
struct Rule {
  const char* figure;
  bool deep;  ///< stands on the counted grains (counted_grains.h); otherwise on all in the cavity
  std::size_t parts;
};

const std::vector<Rule>& rules() {
  static const std::vector<Rule> all = {{"solid_fraction_field_std", true, 1},
                                        {"solid_fraction_top_minus_bottom", true, kThirds},
                                        {"solid_fraction_harmonic_1", true, kHarmonicTerms},
                                        {"solid_fraction_harmonic_1_azimuth_deg", true, kHarmonicTerms},
                                        {"solid_fraction_harmonic_2", true, kHarmonicTerms},
                                        {"solid_fraction_harmonic_2_azimuth_deg", true, kHarmonicTerms},
                                        {"solid_fraction_along_travel_1", true, kTravelTerms},
                                        {"solid_fraction_along_travel_2", true, kTravelTerms},
                                        {"axial_variation", true, kThirds},
                                        {"azimuthal_variation", false, kSectors},
                                        {"mean_grain_diameter_filled_mm", false, 1},
                                        {"mean_grain_diameter_top_minus_bottom_mm", false, kThirds},
                                        {"mixing_index_height", false, kThirds},
                                        {"mixing_index_azimuth", false, kSectors},
                                        {"mixing_index_travel", false, kThirds},
                                        {"first_powder_mass_share_filled", false, 1},
                                        {"powder_mixing_index_height", false, kThirds},
                                        {"powder_mixing_index_azimuth", false, kSectors},
                                        {"powder_mixing_index_travel", false, kThirds}};
  return all;
}

void withhold_undetermined(results::FillResult& result) {
  const char* const groups[][4] = {
      {"solid_fraction_harmonic_1", "solid_fraction_harmonic_1_azimuth_deg", "solid_fraction_harmonic_2",
       "solid_fraction_harmonic_2_azimuth_deg"},
      {"solid_fraction_along_travel_1", "solid_fraction_along_travel_2", nullptr, nullptr}};
  for (const auto& group : groups) {
    const auto beyond = [&](const char* name) {
      const auto found = name == nullptr ? result.figures.end() : result.figures.find(name);
      return found != result.figures.end() && !std::string(name).ends_with("_deg") &&
             std::abs(found->second) > result.summary.mean;
    };
    if (std::none_of(std::begin(group), std::end(group), beyond)) continue;
    for (const char* name : group)
      if (name != nullptr && result.figures.contains(name))
        results::set_no_value(result, name, "the grains occupy too small a part of the cavity");
  }
}

}  // namespace

std::string too_few_text(std::size_t grains, const std::string& where, std::size_t needed) {
  const std::string found = grains == 0   ? "no grain lies "
                            : grains == 1 ? "only 1 grain lies "
                                          : "only " + std::to_string(grains) + " grains lie ";
  return found + where + "; " + std::to_string(needed) + " are needed";
}

results::SolidFractionSummary reliable_summary(results::SolidFractionSummary summary) {
  if (summary.grains >= kMinGrains) return summary;
  const double none = std::numeric_limits<double>::quiet_NaN();
  summary.mean = summary.arithmetic_mean = summary.std = summary.min = summary.max = summary.cv = none;
  return summary;
}

void withhold_poor_figures(results::FillResult& result) {
  const std::size_t deep = result.summary.grains;
  const auto filled = static_cast<std::size_t>(
      std::count(result.solid_fraction.in_cavity.begin(), result.solid_fraction.in_cavity.end(), 1));
  result.summary = reliable_summary(result.summary);
  if (deep < kMinGrains && result.cavity.volume > 0)
    results::add_statement(result, results::kNoValueTopic, "solid_fraction",
                           too_few_text(deep, kDeep, kMinGrains));
  for (const Rule& rule : rules()) {
    const std::size_t grains = rule.deep ? deep : filled, needed = rule.parts * kMinGrains;
    const auto figure = result.figures.find(rule.figure);
    if (figure == result.figures.end()) continue;
    if (grains < needed)
      results::set_no_value(result, rule.figure,
                            too_few_text(grains, rule.deep ? kDeep : "in the cavity", needed));
    else if (!std::isfinite(figure->second))
      results::set_no_value(result, rule.figure,
                            "one of the compared regions of the cavity contains no grain to count");
  }
  withhold_undetermined(result);
}

}  // namespace diefill::process
