#include "process/laboratory/bed_contacts.h"

#include <algorithm>
#include <set>

#include "engine/observe/grain_contacts.h"

namespace diefill::process::laboratory {

namespace {

constexpr double kBinWidth = 5e-5;  // of h / d
constexpr std::size_t kBins = 200;

}  // namespace

void contact_figures(const engine::Simulation& simulation, double grain_diameter, BedFigures& figures) {
  std::vector<double> histogram(kBins, 0.0);
  std::set<std::pair<std::size_t, std::size_t>> touching;
  double sum = 0;
  engine::visit_grain_contacts(simulation, [&](std::size_t i, std::size_t j, double overlap) {
    const double ratio = overlap / grain_diameter;
    ++figures.contacts;
    sum += ratio;
    touching.insert({std::min(i, j), std::max(i, j)});
    ++histogram[std::min(kBins - 1, static_cast<std::size_t>(ratio / kBinWidth))];
  });
  const auto contacts = static_cast<double>(std::max<std::size_t>(1, figures.contacts));
  figures.mean_overlap = sum / contacts;
  for (std::size_t b = 0; b < kBins; ++b) {
    figures.overlap.push_back((static_cast<double>(b) + 0.5) * kBinWidth);
    figures.frequency.push_back(histogram[b] / contacts);
  }
  const auto peak = std::max_element(histogram.begin(), histogram.end()) - histogram.begin();
  figures.overlap_peak = figures.overlap[static_cast<std::size_t>(peak)];

  const auto& grains = simulation.grains();
  double top = 0;
  for (const auto& position : grains.position) top = std::max(top, position[2]);
  const auto counts = [&](std::size_t k) {
    const double z = grains.position[k][2];
    return z > 2 * grain_diameter && z < top - 2 * grain_diameter;
  };
  double neighbours = 0, counted = 0;
  for (const auto& [i, j] : touching) neighbours += (counts(i) ? 1 : 0) + (counts(j) ? 1 : 0);
  for (std::size_t k = 0; k < grains.size(); ++k) counted += counts(k) ? 1 : 0;
  figures.coordination = counted > 0 ? neighbours / counted : 0;
  figures.coordination_of_all =
      2 * static_cast<double>(touching.size()) / static_cast<double>(std::max<std::size_t>(1, grains.size()));
}

}  // namespace diefill::process::laboratory
