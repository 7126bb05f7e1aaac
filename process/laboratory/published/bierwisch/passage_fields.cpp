#include "process/laboratory/published/bierwisch/passage_fields.h"

#include <algorithm>

#include "process/results/figure_table.h"

namespace diefill::process::laboratory {
namespace {

constexpr double kPublishedWidth = 0.5e-3;  // m, sigma

}  // namespace

PassageFields passage_fields(const SeedResults& seed, const std::string& run,
                             const std::vector<std::string>& instants, double speed) {
  std::vector<Eigen::Vector3d> grains, closed;
  std::vector<double> speeds, fractions;
  const double settled = results::figure_of(seed.at(run, "settled"), "bulk_solid_fraction");
  for (const std::string& instant : instants) {
    const results::FillResult& result = seed.at(run, instant);
    for (std::size_t k = 0; k < result.powder.position.size(); ++k) {
      grains.push_back(result.powder.position[k]);
      speeds.push_back(result.powder.velocity[k].norm() / speed);
      if (result.solid_fraction.open[k] != 0) continue;
      closed.push_back(result.powder.position[k]);
      fractions.push_back(result.solid_fraction.solid_fraction[k] / settled);
    }
  }
  const results::PowderState& powder = seed.of(run).powder;
  const double width = std::max(kPublishedWidth, 0.5 * powder.grain_diameter);
  const Period period = period_of(powder);
  return {GaussianField::of_all_grains(grains, std::move(speeds), powder.grain_diameter, width, period),
          GaussianField::of_all_grains(closed, std::move(fractions), powder.grain_diameter, width, period),
          width};
}

}  // namespace diefill::process::laboratory
