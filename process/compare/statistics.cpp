#include "process/compare/statistics.h"

#include <cmath>
#include <numbers>

#include "process/results/none.h"
#include "process/results/studies/mean.h"
#include "process/results/studies/quantiles.h"

namespace diefill::process {
namespace {

/// Direction of the sum of unit vectors, in 0 to `period`.
double mean_direction(const std::vector<double>& values, double period) {
  double cosines = 0, sines = 0;
  for (const double value : values) {
    cosines += std::cos(2 * std::numbers::pi * value / period);
    sines += std::sin(2 * std::numbers::pi * value / period);
  }
  const double mean = std::atan2(sines, cosines) * period / (2 * std::numbers::pi);
  return mean < 0 ? mean + period : mean;
}

}  // namespace

double difference(double a, double b, double period) {
  return period > 0 ? std::remainder(b - a, period) : b - a;
}

Sample sample_of(const std::vector<double>& values, double period) {
  std::vector<double> finite;
  for (const double value : values)
    if (std::isfinite(value)) finite.push_back(value);
  Sample sample{kNone, kNone, finite.size()};
  if (finite.empty()) return sample;
  sample.mean = period > 0 ? mean_direction(finite, period) : results::mean_of(finite);
  if (finite.size() < 2) return sample;
  double squares = 0;
  for (const double value : finite) squares += std::pow(difference(sample.mean, value, period), 2);
  sample.scatter = std::sqrt(squares / static_cast<double>(finite.size() - 1));
  return sample;
}

double welch_half_width(const Sample& a, const Sample& b) {
  if (a.count < 2 || b.count < 2) return kNone;
  const double n_a = static_cast<double>(a.count), n_b = static_cast<double>(b.count);
  const double part_a = a.scatter * a.scatter / n_a, part_b = b.scatter * b.scatter / n_b;
  const double sum = part_a + part_b;
  if (!(sum > 0)) return 0;
  const double freedom = sum * sum / (part_a * part_a / (n_a - 1) + part_b * part_b / (n_b - 1));
  return results::student_95(freedom) * std::sqrt(sum);
}

}  // namespace diefill::process
