#include "process/estimate/statements/wording.h"

#include <algorithm>
#include <cmath>

#include "process/estimate/statements/limits.h"
#include "process/results/formatted.h"
#include "process/results/rounding.h"

namespace diefill::process::estimate {

namespace {

std::size_t cavity_count(const Estimate& estimate) {
  std::size_t cavities = estimate.unseen.size();
  for (const auto& opening : estimate.openings) cavities += opening.is_cavity ? 1 : 0;
  return cavities;
}

}  // namespace

std::string times(std::size_t crossings) {
  return crossings == 1 ? "one crossing" : std::to_string(crossings) + " crossings";
}

std::string with_grains(double diameter) {
  return results::formatted(" with grains of %.3g mm", 1e3 * diameter);
}

std::string place_text(const Eigen::Vector2d& centre) {
  // Nothing smaller than a hundredth of a millimetre, nor -0.
  const auto rounded = [](double metres) { return std::round(1e5 * metres) / 100 + 0.0; };
  return results::formatted(" at x = %.4g mm, y = %.4g mm", rounded(centre.x()), rounded(centre.y()));
}

std::string name_of(const Estimate& estimate, const OpeningEstimate& opening) {
  if (!opening.is_cavity || cavity_count(estimate) < 2) return "the " + opening.name;
  return opening.name + place_text(opening.centre);
}

double percent_up_to_full(double share) {
  return std::min(100.0, 100 * share);
}

std::string error_text(const Estimate& estimate) {
  const KnownError& error = estimate.error;
  if (!error.measured)
    return results::formatted(
        "not measured for this powder; a factor of %.3g either way on the inflow is assumed", error.factor);
  return results::formatted(
             "in 90 %% of cases a factor of at most %.3g on the inflow, and %.0f %% on the mass (",
             error.factor, 100 * error.packing) +
         error.source + ")";
}

std::string valid_text(const Estimate& estimate) {
  std::string text = results::formatted(
      "shoe speeds up to %.2g sqrt(g D), more where the opening is longer along the motion than wide; powder "
      "at "
      "least %.3g mm deep in the shoe; grains up to %.2f of the width",
      kLargestFroude, 1e3 * kShallowestPowder, kCoarsestGrain);
  if (std::isfinite(estimate.law.largest_bond))
    text += results::formatted("; Bond numbers up to %.3g", estimate.law.largest_bond);
  if (std::isfinite(estimate.law.longest))
    text += results::formatted("; flow times up to %.3g sqrt(D/g), beyond them at a constant rate",
                               estimate.law.longest + 0.2);
  return text;
}

std::string outlet_text(const Estimate& estimate) {
  const OutletEstimate& outlet = *estimate.outlet;
  std::string text =
      outlet.round ? results::formatted("a round opening of %.3g mm", 1e3 * outlet.width)
                   : results::formatted("a slit of %.3g x %.3g mm", 1e3 * outlet.width, 1e3 * outlet.length);
  text += results::formatted(" at z = %.3g mm", 1e3 * outlet.height);
  if (!(outlet.rate > 0))
    return text + " is too narrow for" + with_grains(estimate.grain_diameter).substr(5) +
           ": nothing runs out; take finer grains";
  return "out of " + text + " run " + results::mass_text(outlet.rate) + "/s" +
         with_grains(estimate.grain_diameter) + " once the flow is steady; " +
         results::mass_text(outlet.mass) +
         results::formatted(" above it take about %.2g s, less what rests beside it",
                            outlet.mass / outlet.rate);
}

std::string powders_text(const Estimate& estimate) {
  if (estimate.powder.left_out.empty()) return {};
  return "estimated as if all powder were " + estimate.powder.name + ": " + estimate.powder.left_out +
         " of [[other_powder]] is not taken into account";
}

const OpeningEstimate* emptiest(const Estimate& estimate) {
  const OpeningEstimate* worst = nullptr;
  for (const auto& opening : estimate.openings)
    if (opening.is_cavity && !opening.offered.empty() && (worst == nullptr || opening.share < worst->share))
      worst = &opening;
  return worst;
}

}  // namespace diefill::process::estimate
