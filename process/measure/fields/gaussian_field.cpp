#include "process/measure/fields/gaussian_field.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace diefill::process {
namespace {

constexpr double kHoleOverDiameter = 1.2;
constexpr double kHoleOverWidth = 1.5;

double checked(double averaging_width) {
  if (!(averaging_width > 0)) throw std::invalid_argument("the averaging width of a field must be positive");
  return averaging_width;
}

double hole_distance(double averaging_width, double grain_diameter) {
  return std::max(kHoleOverDiameter * grain_diameter, kHoleOverWidth * averaging_width);
}

double reach(double averaging_width, double hole) {
  return std::max(kReachOverWidth * averaging_width, hole);
}

}  // namespace

GaussianField::GaussianField(const results::PowderState& powder, const results::GrainSolidFraction& fraction,
                             double averaging_width)
    : GaussianField(closed_grains(powder, fraction,
                                  reach(checked(averaging_width),
                                        hole_distance(averaging_width, powder.grain_diameter))),
                    averaging_width, hole_distance(averaging_width, powder.grain_diameter)) {}

GaussianField::GaussianField(Source source, double averaging_width, double hole)
    : averaging_width_(averaging_width),
      hole_(hole),
      reach_(reach(averaging_width, hole)),
      values_(std::move(source.values)),
      grid_(source.centres, 0.5 * reach_) {}

GaussianField GaussianField::of_all_grains(const std::vector<Eigen::Vector3d>& centres,
                                           std::vector<double> values, double grain_diameter,
                                           double averaging_width, const Period& period) {
  const double hole = hole_distance(checked(averaging_width), grain_diameter);
  return {with_images({centres, std::move(values)}, reach(averaging_width, hole), period), averaging_width,
          hole};
}

GaussianField::Source GaussianField::closed_grains(const results::PowderState& powder,
                                                   const results::GrainSolidFraction& fraction,
                                                   double margin) {
  Source source;
  for (std::size_t k = 0; k < powder.position.size(); ++k) {
    if (fraction.open[k] != 0) continue;
    source.centres.push_back(powder.position[k]);
    source.values.push_back(fraction.solid_fraction[k]);
  }
  return with_images(std::move(source), margin, period_of(powder));
}

GaussianField::Source GaussianField::with_images(Source source, double margin, const Period& period) {
  const geometry::PointImages images = geometry::with_periodic_images(source.centres, period, margin);
  source.centres = images.points;
  std::vector<double> values;
  values.reserve(images.source.size());
  for (const std::uint32_t grain : images.source) values.push_back(source.values[grain]);
  source.values = std::move(values);
  return source;
}

double GaussianField::at(const Eigen::Vector3d& point) const {
  return value(point, hole_);
}

double GaussianField::mean_at(const Eigen::Vector3d& point) const {
  return value(point, reach_);
}

double GaussianField::value(const Eigen::Vector3d& point, double hole) const {
  const double exponent = -0.5 / (averaging_width_ * averaging_width_);
  double nearest = std::numeric_limits<double>::max(), weights = 0, sum = 0;
  grid_.for_each_within(point, reach_, [&](std::uint32_t grain, const auto&, double squared) {
    const double weight = std::exp(exponent * squared);
    nearest = std::min(nearest, squared);
    weights += weight;
    sum += weight * values_[grain];
  });
  return nearest <= hole * hole && weights > 0 ? sum / weights : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace diefill::process
