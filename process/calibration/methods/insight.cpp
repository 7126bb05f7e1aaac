#include "process/calibration/methods/insight.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "process/results/rounding.h"
#include "process/results/word_list.h"

namespace diefill::process::calibration {
namespace {

constexpr double kAlongALine = 0.8;   // correlation from which two parameters are fixed only together
constexpr double kLeftOpen = 0.7;     // share of its range from which a parameter counts as unknown; an even
                                      // distribution has 0.9
constexpr double kOverlapping = 0.4;  // lesser correlation that is worth a word
constexpr double kEnd = 0.1;          // of an interval's width: how far an end of the range reaches
constexpr double kCutOff = 1.5;       // times its share of the samples, at an end where the region is cut off

std::string two_digits(double value) {
  char text[16];
  std::snprintf(text, sizeof text, "%.2f", value);
  return text;
}

Eigen::MatrixXd covariance_of(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  const Eigen::MatrixXd of_a = a.rowwise() - a.colwise().mean(), of_b = b.rowwise() - b.colwise().mean();
  return of_a.transpose() * of_b / static_cast<double>(a.rows() - 1);
}

/// Share of the samples within `reach` of an end of the range.
double share_at_end(const Region& region, Eigen::Index parameter, bool upper, double reach) {
  const auto place = region.samples.col(parameter).array();
  const Eigen::Index count = upper ? (place > 1 - reach).count() : (place < reach).count();
  return static_cast<double>(count) / static_cast<double>(place.size());
}

/// Ends of ranges where the samples do not become fewer: parameters beyond may fit as well.
void add_cut_off(const Region& region, const std::vector<std::string>& parameters,
                 std::vector<std::string>& sentences) {
  for (std::size_t d = 0; d < parameters.size(); ++d) {
    const auto at = static_cast<Eigen::Index>(d);
    const double reach = kEnd * (region.upper[at] - region.lower[at]);
    for (const bool upper : {false, true})
      if (share_at_end(region, at, upper, reach) > kCutOff * kEnd * region.share)
        sentences.push_back(
            "the region is cut off where the range of " + parameters[d] + (upper ? " ends" : " begins") +
            ": powders beyond may fit as well or better; widen it if such powders are possible");
  }
}

}  // namespace

std::vector<std::string> insights(const Region& region, const std::vector<std::string>& parameters,
                                  const std::vector<std::string>& measured_by) {
  std::vector<std::string> sentences;
  const std::string data = measured_by.empty() ? "the measurements" : results::and_list(measured_by);
  const bool one = measured_by.size() == 1;
  const std::string says = one ? " alone says" : " together say",
                    fixes = one ? " alone fixes " : " together fix ";
  for (std::size_t d = 0; d < parameters.size(); ++d) {
    const auto at = static_cast<Eigen::Index>(d);
    const double width = region.upper[at] - region.lower[at];
    if (width > kLeftOpen)
      sentences.push_back(data + says + " next to nothing about " + parameters[d] + ": its interval is " +
                          results::whole_percent(width) + " of the range");
  }
  add_cut_off(region, parameters, sentences);
  for (std::size_t i = 0; i < parameters.size(); ++i)
    for (std::size_t j = i + 1; j < parameters.size(); ++j) {
      const double r = region.correlation(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
      if (std::abs(r) < kOverlapping) continue;
      const std::string together =
          r < 0 ? "more of one makes up for less of the other" : "both rise together";
      const std::string pair = parameters[i] + " and " + parameters[j];
      if (std::abs(r) >= kAlongALine)
        sentences.push_back(data + fixes + pair + " only along a line: " + together + " (correlation " +
                            two_digits(r) +
                            "); a measurement that depends on them otherwise would separate them");
      else
        sentences.push_back(pair + " are partly fixed together: " + together + " (correlation " +
                            two_digits(r) + ")");
    }
  return sentences;
}

std::vector<Informativeness> informativeness_of(const Eigen::MatrixXd& samples,
                                                const std::vector<PossibleMeasurement>& possible) {
  std::vector<Informativeness> all;
  const Eigen::MatrixXd now = covariance_of(samples, samples);
  for (const PossibleMeasurement& measurement : possible) {
    if (measurement.values.rows() != samples.rows())
      throw std::invalid_argument("a possible measurement has a value for each sample");
    const Eigen::MatrixXd with = covariance_of(samples, measurement.values);
    Eigen::MatrixXd total = covariance_of(measurement.values, measurement.values);
    total.diagonal().array() += measurement.deviations.array().square();
    const Eigen::MatrixXd after = now - with * total.ldlt().solve(with.transpose());
    Informativeness gain;
    gain.name = measurement.name;
    gain.volume = std::sqrt(std::max(0.0, after.determinant() / now.determinant()));
    gain.deviations = (after.diagonal().cwiseMax(0).array() / now.diagonal().array()).sqrt();
    all.push_back(std::move(gain));
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const Informativeness& a, const Informativeness& b) { return a.volume < b.volume; });
  return all;
}

}  // namespace diefill::process::calibration
