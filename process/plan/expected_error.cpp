#include "process/plan/expected_error.h"

#include <array>
#include <cmath>

#include "process/plan/setting.h"

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

constexpr double kSameFactor = 0.05;  // relative

}  // namespace

std::optional<ExpectedError> expected_error(const PowderSpec& powder, double grain_diameter, double width) {
  // Beyond a third of the width grains wedge, which settled powder does not show.
  if (width > 0 && grain_diameter > kCoarsestToDecide * width * (1 + 1e-9)) return std::nullopt;
  const double factor = grain_diameter / calibrated_diameter(powder);
  for (const auto& row : kSettled)
    if (powder.name == row.preset && std::abs(factor / row.factor - 1) < kSameFactor)
      return ExpectedError{"mean solid fraction of settled powder",
                           std::abs(row.found - row.published) / row.published,
                           "README.md, How far to trust it (Bierwisch 2009, Table 4.4)"};
  return std::nullopt;
}

}  // namespace diefill::process::plan
