#include "engine/powder/size_distribution.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <stdexcept>
#include <string>

namespace diefill::engine {
namespace {

/// Share of the standard normal distribution between a and b, without cancellation in either tail.
double normal_between(double a, double b) {
  const double root = std::numbers::sqrt2;
  return a > 0 ? 0.5 * (std::erfc(a / root) - std::erfc(b / root))
               : 0.5 * (std::erfc(-b / root) - std::erfc(-a / root));
}

/// Where the standard normal distribution cut to [low, high] has a share `fraction` below: Newton's steps,
/// halving the bracket where they would leave it.
double normal_quantile(double fraction, double low, double high) {
  const double target = fraction * normal_between(low, high);
  constexpr double kReach = 39;  // beyond this the distribution is zero in double
  double below = std::max(low, -kReach), above = std::min(high, kReach);
  double at = std::clamp(0.0, below, above);
  for (int step = 0; step < 100; ++step) {
    const double excess = normal_between(low, at) - target;
    (excess < 0 ? below : above) = at;
    const double density = std::exp(-0.5 * at * at) / std::sqrt(2 * std::numbers::pi);
    double next = at - excess / density;
    if (!(next > below && next < above)) next = 0.5 * (below + above);
    if (std::abs(next - at) <= 1e-15 * (1 + std::abs(at))) return next;
    at = next;
  }
  return at;
}

void require_positive(const char* name, double value) {
  if (value > 0 && std::isfinite(value)) return;
  throw std::invalid_argument(std::string("size distribution: ") + name + " is " + std::to_string(value) +
                              "; it must be positive");
}

void require_range(SizeCutOffs cut_offs) {
  if (cut_offs.smallest >= 0 && cut_offs.smallest < cut_offs.largest) return;
  throw std::invalid_argument("size distribution: cut-offs " + std::to_string(cut_offs.smallest) + " m to " +
                              std::to_string(cut_offs.largest) +
                              " m leave no sizes; the smallest must be below the largest");
}

double power_of_mass(SizeBasis basis) {
  return basis == SizeBasis::mass ? 3 : 0;
}

}  // namespace

SizeDistribution SizeDistribution::single(double diameter) {
  return discrete({{diameter, 1}}, SizeBasis::number);
}

SizeDistribution SizeDistribution::discrete(std::vector<SizeClass> classes, SizeBasis basis,
                                            SizeCutOffs cut_offs) {
  require_range(cut_offs);
  for (auto& one : classes) {
    require_positive("diameter of a class", one.diameter);
    require_positive("share of a class", one.share);
    one.share /= std::pow(one.diameter / classes.front().diameter, power_of_mass(basis));
  }
  std::erase_if(classes, [&](const SizeClass& one) {
    return one.diameter < cut_offs.smallest || one.diameter > cut_offs.largest;
  });
  if (classes.empty()) throw std::invalid_argument("size distribution: no class lies within the cut-offs");
  std::stable_sort(classes.begin(), classes.end(),
                   [](const SizeClass& a, const SizeClass& b) { return a.diameter < b.diameter; });
  double sum = 0;
  for (const auto& one : classes) sum += one.share;
  for (auto& one : classes) one.share /= sum;

  SizeDistribution made;
  made.classes_ = std::move(classes);
  return made;
}

SizeDistribution SizeDistribution::log_normal(double median, double log_deviation, SizeBasis basis,
                                              SizeCutOffs cut_offs) {
  require_positive("median", median);
  require_positive("deviation of the logarithm", log_deviation);
  require_range(cut_offs);
  SizeDistribution made;
  made.log_median_ = std::log(median) - power_of_mass(basis) * log_deviation * log_deviation;
  made.log_deviation_ = log_deviation;
  made.cut_offs_ = cut_offs;
  const double low = made.standard(cut_offs.smallest), high = made.standard(cut_offs.largest);
  const double shift = 3 * log_deviation;
  if (!(normal_between(low, high) > 0 && normal_between(low - shift, high - shift) > 0))
    throw std::invalid_argument("size distribution: the cut-offs lie so far from the median of " +
                                std::to_string(median) + " m that nothing is left; widen them");
  return made;
}

SizeDistribution SizeDistribution::log_normal_of_mean(double mean, double deviation, SizeCutOffs cut_offs) {
  require_positive("mean", mean);
  require_positive("deviation", deviation);
  const double spread = deviation / mean;
  return log_normal(mean / std::sqrt(1 + spread * spread), std::sqrt(std::log1p(spread * spread)),
                    SizeBasis::number, cut_offs);
}

double SizeDistribution::class_fraction(double diameter, double power) const {
  double below = 0, sum = 0;
  for (const auto& one : classes_) {
    const double weight = one.share * std::pow(one.diameter / classes_.back().diameter, power);
    sum += weight;
    if (one.diameter <= diameter) below += weight;
  }
  return below / sum;
}

double SizeDistribution::standard(double diameter) const {
  return (std::log(diameter) - log_median_) / log_deviation_;
}

// Share with weight d^power between the lower cut-off and exp(log_diameter), over all that lies within the
// cut-offs: the weight moves the normal distribution of ln d by power sigma^2.
double SizeDistribution::tilted_fraction(double log_diameter, double power) const {
  const double shift = power * log_deviation_;
  const double low = standard(cut_offs_.smallest) - shift, high = standard(cut_offs_.largest) - shift;
  const double here = std::clamp((log_diameter - log_median_) / log_deviation_ - shift, low, high);
  return normal_between(low, here) / normal_between(low, high);
}

double SizeDistribution::fraction_below(double diameter, SizeBasis basis) const {
  if (!classes_.empty()) return class_fraction(diameter, power_of_mass(basis));
  return diameter > 0 ? tilted_fraction(std::log(diameter), power_of_mass(basis)) : 0;
}

double SizeDistribution::quantile(double fraction, SizeBasis basis) const {
  for (const auto& one : classes_)
    if (fraction < class_fraction(one.diameter, power_of_mass(basis))) return one.diameter;
  if (!classes_.empty()) return classes_.back().diameter;

  const double shift = power_of_mass(basis) * log_deviation_;
  const double low = standard(cut_offs_.smallest) - shift, high = standard(cut_offs_.largest) - shift;
  const double place = normal_quantile(fraction, low, high) + shift;
  return std::clamp(std::exp(log_median_ + place * log_deviation_), cut_offs_.smallest, cut_offs_.largest);
}

double SizeDistribution::moment(double power) const {
  if (!classes_.empty()) {
    double sum = 0;
    for (const auto& one : classes_) sum += one.share * std::pow(one.diameter, power);
    return sum;
  }
  const double shift = power * log_deviation_;
  const double low = standard(cut_offs_.smallest), high = standard(cut_offs_.largest);
  return std::exp(power * log_median_ + 0.5 * shift * shift) * normal_between(low - shift, high - shift) /
         normal_between(low, high);
}

double SizeDistribution::mean_mass(double density) const {
  return density * std::numbers::pi / 6 * moment(3);
}

std::vector<double> SizeDistribution::sample(std::size_t count, std::uint64_t seed) const {
  std::mt19937_64 random(seed);  // its numbers are fixed by the standard; those of distributions are not
  std::vector<double> diameters(count);
  for (auto& diameter : diameters) diameter = sample(static_cast<double>(random() >> 11) * 0x1p-53);
  return diameters;
}

std::vector<double> SizeDistribution::class_diameters() const {
  std::vector<double> diameters;
  for (const auto& one : classes_) diameters.push_back(one.diameter);
  return diameters;
}

SizeCutOffs SizeDistribution::range() const {
  if (!classes_.empty()) return {classes_.front().diameter, classes_.back().diameter};
  return cut_offs_;
}

SizeDistribution SizeDistribution::scaled(double scale) const {
  require_positive("scale", scale);
  SizeDistribution made = *this;
  for (auto& one : made.classes_) one.diameter *= scale;
  made.log_median_ += std::log(scale);
  made.cut_offs_ = {cut_offs_.smallest * scale, cut_offs_.largest * scale};
  return made;
}

}  // namespace diefill::engine
