// Cavities that are too narrow for the scene's grains.
#include <algorithm>

#include "process/powder/empty_annulus.h"
#include "process/results/formatted.h"
#include "process/setup/setup_findings.h"

namespace diefill::process {

namespace {

constexpr double kReliable = 1.0 / 3;  // grain over width, up to which fillings are reliable

/// "cavity 2" of several, "the cavity" of one.
std::string name_of(std::size_t number, std::size_t cavities) {
  return cavities == 1 ? "the cavity" : "cavity " + std::to_string(number + 1);
}

SetupFinding too_narrow(const geometry::Cavity& cavity, const std::string& name, double grain) {
  const double width = cavity.narrowest_width;
  const Eigen::Vector3d place = 1e3 * cavity.narrowest_place;
  const std::string fits =
      grain >= width
          ? std::string("the grains do not fit in")
          : results::formatted("grains get stuck in widths below %.2g of their size", kEmptyAnnulus);
  return {
      results::formatted("grains of %.3g mm do not run to the floor of ", 1e3 * grain) + name +
          results::formatted(", which is %.3g mm wide at its narrowest, near (%.4g, %.4g, %.4g) mm: ",
                             1e3 * width, place.x(), place.y(), place.z()) +
          fits +
          results::formatted("; use grains of at most a third of the width, %.3g mm (powder.grain_diameter), "
                             "or a wider cavity",
                             1e3 * kReliable * width),
      {cavity.narrowest_place}};
}

}  // namespace

std::vector<SetupFinding> cavity_findings(const Scene& scene, const Tooling& tooling) {
  std::vector<SetupFinding> findings;
  std::vector<geometry::Cavity> cavities = {tooling.cavity};
  cavities.insert(cavities.end(), tooling.other_cavities.begin(), tooling.other_cavities.end());
  const double grain = scene.powder.grain_diameter;  // of a graded pour, the one that is to run in
  for (std::size_t k = 0; k < cavities.size(); ++k)
    if (cavities[k].narrowest_width > 0 && kEmptyAnnulus * grain > cavities[k].narrowest_width)
      findings.push_back(too_narrow(cavities[k], name_of(k, cavities.size()), grain));
  return findings;
}

}  // namespace diefill::process
