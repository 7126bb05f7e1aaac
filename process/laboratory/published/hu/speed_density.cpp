#include "process/laboratory/published/hu/speed_density.h"

#include <algorithm>
#include <cmath>

#include "process/results/storage/result_file.h"

namespace diefill::process::laboratory {
namespace {

constexpr std::size_t kBins = 30;
constexpr double kBin = 0.05;       // m/s
constexpr double kRounding = 1e-9;  // s

}  // namespace

double SpeedDensity::peak() const {
  double best = -1, place = 0;
  for (std::size_t k = 0; k < density.size(); ++k) {
    double sum = density[k], count = 1;
    if (k > 0) sum += density[k - 1], ++count;
    if (k + 1 < density.size()) sum += density[k + 1], ++count;
    if (sum / count > best) best = sum / count, place = speed[k];
  }
  return place;
}

double SpeedDensity::linearity(double up_to) const {
  double count = 0, x = 0, y = 0, xx = 0, xy = 0, yy = 0;
  for (std::size_t k = 0; k < speed.size() && speed[k] <= up_to; ++k) {
    ++count;
    x += speed[k], y += density[k];
    xx += speed[k] * speed[k], xy += speed[k] * density[k], yy += density[k] * density[k];
  }
  const double with = count * xy - x * y, of_x = count * xx - x * x, of_y = count * yy - y * y;
  // A falling line is none that rises with the speed.
  return with > 0 ? with * with / (of_x * of_y) : 0;
}

SpeedDensity speed_density(const results::FillResult& result, double end, double seconds) {
  SpeedDensity found;
  std::vector<double> counts(kBins, 0.0);
  double all = 0;
  for (const results::Instant& instant : result.instants) {
    if (instant.time < end - seconds - kRounding || instant.time > end + kRounding) continue;
    for (const auto& velocity : instant.velocity) {
      const double speed = velocity.norm();
      found.mean += speed;
      ++all;
      const auto bin = static_cast<std::size_t>(speed / kBin);
      if (bin < kBins) ++counts[bin];
    }
  }
  if (all == 0) throw results::ResultError("the results have no instants while the impeller turns");
  found.mean /= all;
  for (std::size_t k = 0; k < kBins; ++k) {
    found.speed.push_back((static_cast<double>(k) + 0.5) * kBin);
    found.density.push_back(counts[k] / (all * kBin));
  }
  return found;
}

double difference(const SpeedDensity& one, const SpeedDensity& other) {
  double sum = 0;
  for (std::size_t k = 0; k < one.density.size(); ++k)
    sum += std::abs(one.density[k] - other.density[k]) * kBin;
  return sum;
}

}  // namespace diefill::process::laboratory
