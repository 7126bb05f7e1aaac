#include "process/measure/figures/verdict.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "process/measure/figures/cavity_parts.h"
#include "process/measure/figures/counted_grains.h"
#include "process/measure/figures/enough_grains.h"
#include "process/results/full_die.h"
#include "process/results/no_value.h"
#include "process/results/rounding.h"

namespace diefill::process {
namespace {

constexpr double kMinDeficit = 0.02;     // of the mean
constexpr double kStandardErrors = 2;    // beyond which a difference is more than scatter
constexpr double kLevelAllowance = 0.5;  // grain diameters: a surface of grains is no finer

double value(const results::FillResult& result, const std::string& name) {
  const auto found = result.figures.find(name);
  return found == result.figures.end() ? std::numeric_limits<double>::quiet_NaN() : found->second;
}

/// Mean solid fraction of the counted grains in one part, with its standard error.
struct PartMean {
  std::string words;
  std::size_t grains = 0;
  double mean = 0, error = 0;
};

PartMean mean_of(const results::FillResult& result, const CavityPart& part,
                 const std::vector<std::size_t>& counted) {
  PartMean found{part.words};
  double solid = 0, cells = 0, sum = 0, squares = 0;
  for (const std::size_t k : counted) {
    if (!part.holds(result.powder.position[k])) continue;
    const double fraction = result.solid_fraction.solid_fraction[k];
    solid += result.powder.solid_volume_of(k);
    cells += result.solid_fraction.cell_volume[k];
    sum += fraction;
    squares += fraction * fraction;
    ++found.grains;
  }
  const auto n = static_cast<double>(found.grains);
  found.mean = solid / cells;
  found.error = std::sqrt(std::max(0.0, squares / n - sum * sum / n / n) / n);
  return found;
}

/// "; too few grains to judge the powder where the shoe arrives" of the parts that hold powder but too few
/// counted grains for a mean; empty where there are none.
std::string too_sparse(const results::FillResult& result, const std::vector<CavityPart>& parts,
                       const std::vector<std::size_t>& counted) {
  const auto& inside = result.solid_fraction.in_cavity;
  std::string words;
  for (const auto& part : parts) {
    if (mean_of(result, part, counted).grains >= kMinGrains) continue;
    bool powder = false;
    for (std::size_t k = 0; k < inside.size() && !powder; ++k)
      powder = inside[k] == 1 && part.holds(result.powder.position[k]);
    if (powder) words += (words.empty() ? " " : " and ") + part.words;
  }
  return words.empty() ? words : "; too few grains to judge the powder" + words;
}

/// "where the shoe leaves (solid fraction 0.28, mean 0.32)", to the decimals that the part's error leaves.
std::string description_of(const PartMean& part, double mean) {
  const int decimals = part.error > 0 ? results::decimals_of_scatter(part.error) : 3;
  return part.words + " (solid fraction " + results::at_decimals(part.mean, decimals) + ", mean " +
         results::at_decimals(mean, decimals) + ")";
}

/// "90 % full: 3.12 g of the 3.43 g that ...".
std::string filling(const results::FillResult& result) {
  const double ratio = value(result, "fill_ratio"), mass = value(result, "expected_mass_kg");
  const bool guessed = value(result, "apparent_density_is_estimate") > 0;
  const int digits = guessed ? 2 : 3;
  const std::string holds = (guessed ? "about " : "") + results::mass_text(mass, digits);
  const std::string full = results::mass_text(value(result, "full_die_mass_kg"), digits);
  if (!std::isfinite(ratio)) {
    const double guess = value(result, "estimated_mass_kg");
    return (std::isfinite(guess) ? "holds about " + results::mass_text(guess, 2) + "; " : std::string()) +
           "fill ratio unknown: " + results::reason_for(result, "fill_ratio");
  }
  if (results::is_full(ratio))
    return "full (" + results::whole_percent(ratio) + "): " + holds +
           ", a die full at apparent density holds " + full;
  return results::whole_percent(ratio) + " full: " + holds + " of the " + full +
         " of a die full at apparent density";
}

/// The part where the profile "fill level" stands lowest; empty where it is level.
std::string lowest_part(const results::FillResult& result) {
  for (const auto& profile : result.profiles) {
    if (profile.quantity != "fill level" || profile.y.size() < 4) continue;
    const bool ring = profile.x_unit == "deg";
    const auto parts = horizontal_parts(result);
    double sum[3] = {0, 0, 0}, count[3] = {0, 0, 0}, all = 0;
    for (std::size_t n = 0; n < profile.y.size(); ++n) {
      const double level = std::isfinite(profile.y[n]) ? profile.y[n] : 0;
      const double off = std::abs(std::remainder(profile.x[n], 360));
      const std::size_t part = ring ? (off <= 45 ? 0 : off < 135 ? 1 : 2) : 3 * n / profile.y.size();
      sum[part] += level;
      ++count[part];
      all += level / static_cast<double>(profile.y.size());
    }
    std::size_t lowest = 0;
    for (std::size_t k = 1; k < 3; ++k)
      if (sum[k] / count[k] < sum[lowest] / count[lowest]) lowest = k;
    const double allowed = 1e3 * kLevelAllowance * result.powder.grain_diameter;
    if (all - sum[lowest] / count[lowest] > allowed) return parts[lowest].words;
  }
  return {};
}

std::string surface(const results::FillResult& result) {
  const double height = value(result, "fill_height_mm");
  const double depth = 1e3 * (result.cavity.upper_corner.z() - result.cavity.lower_corner.z());
  const double low = depth - height;
  if (!(low > 1e3 * kLevelAllowance * result.powder.grain_diameter)) return {};
  const std::string lowest = lowest_part(result);
  return "; surface " + results::in_significant_digits(low, 2) + " mm below the fill plane" +
         (lowest.empty() ? "" : ", lowest " + lowest);
}

}  // namespace

std::string loosest_part(const results::FillResult& result, bool& known) {
  const auto counted = counted_grains(result.powder, result.solid_fraction, true);
  const PartMean all = mean_of(result, {"", [](const Eigen::Vector3d&) { return true; }}, counted);
  PartMean loosest;
  std::string beside;
  double deepest = 0;
  known = false;
  for (const auto& parts : {horizontal_parts(result), vertical_parts(result)}) {
    const std::string unjudged = too_sparse(result, parts, counted);
    for (const auto& part : parts) {
      const PartMean found = mean_of(result, part, counted);
      if (found.grains < kMinGrains || found.grains == all.grains) continue;
      known = true;
      const double deficit = all.mean - found.mean;
      if (deficit <= deepest || deficit < kMinDeficit * all.mean || deficit < kStandardErrors * found.error)
        continue;
      deepest = deficit;
      loosest = found;
      beside = unjudged;
    }
  }
  return loosest.words.empty() ? std::string() : description_of(loosest, all.mean) + beside;
}

std::string verdict(const results::FillResult& result) {
  const auto& inside = result.solid_fraction.in_cavity;
  const auto filled = static_cast<std::size_t>(std::count(inside.begin(), inside.end(), 1));
  if (filled == 0) return "empty: no powder in the cavity";
  bool known = false;
  const std::string loose = loosest_part(result, known);
  std::string text = filling(result);
  if (!loose.empty())
    text += "; loosest " + loose;
  else if (known)
    text += "; no region significantly looser than the rest" +
            too_sparse(result, horizontal_parts(result),
                       counted_grains(result.powder, result.solid_fraction, true));
  else
    text += "; too few grains to locate loose regions";
  return text + surface(result);
}

}  // namespace diefill::process
