#include <cmath>
#include <numbers>

#include "process/measure/cavity_position.h"
#include "process/measure/figures/counted_grains.h"
#include "process/measure/figures/figures.h"
#include "process/measure/figures/weighted_fit.h"

namespace diefill::process {
namespace {

constexpr double kDegrees = 180 / std::numbers::pi;

void add_harmonic(int n, double cosine, double sine, Figures& figures) {
  const std::string name = "solid_fraction_harmonic_" + std::to_string(n);
  double azimuth = kDegrees * std::atan2(sine, cosine) / n;
  if (azimuth < 0) azimuth += 360.0 / n;
  figures[name] = std::hypot(cosine, sine);
  figures[name + "_azimuth_deg"] = azimuth;
}

}  // namespace

void azimuthal_harmonics(const results::FillResult& result, Figures& figures) {
  if (!result.cavity.is_ring) return;
  std::vector<FitPoint<5>> points;
  for (const std::size_t k : counted_grains(result.powder, result.solid_fraction, true)) {
    const double angle = ring_position(result.cavity, result.powder.position[k]).azimuth / kDegrees;
    FitPoint<5> point;
    point.basis << 1, std::cos(angle), std::sin(angle), std::cos(2 * angle), std::sin(2 * angle);
    point.value = result.solid_fraction.solid_fraction[k];
    point.weight = result.solid_fraction.cell_volume[k];
    points.push_back(point);
  }
  const auto fit = weighted_fit(points);
  add_harmonic(1, fit[1], fit[2], figures);
  add_harmonic(2, fit[3], fit[4], figures);
}

}  // namespace diefill::process
