#include "process/measure/fields/stress_field.h"

#include <cmath>
#include <stdexcept>

#include "process/measure/fields/gaussian_field.h"

namespace diefill::process {
namespace {

/// Square of each grain's velocity against the mean of the grains around it, m^2/s^2, by axis. The grain
/// itself stays out of that mean, which would otherwise take part in its motion. The mean of others scatters
/// too: where all velocities are independent, it widens the square by 1 + sum w^2 / (sum w)^2, which is
/// divided out.
std::vector<Eigen::Array3d> squared_fluctuations(const results::PowderState& powder, double averaging_width) {
  const double reach = kReachOverWidth * averaging_width,
               exponent = -0.5 / (averaging_width * averaging_width);
  const auto all = geometry::with_periodic_images(powder.position, period_of(powder), reach);
  const geometry::NeighbourGrid grid(all.points, 0.5 * reach);
  std::vector<Eigen::Array3d> squares(powder.position.size(), Eigen::Array3d::Zero());
  for (std::size_t k = 0; k < squares.size(); ++k) {
    double weights = 0, squared_weights = 0;
    Eigen::Array3d sum = Eigen::Array3d::Zero();
    grid.for_each_within(all.points[k], reach, [&](std::uint32_t image, const auto&, double squared) {
      const std::uint32_t other = all.source[image];
      if (other == k) return;
      const double weight = std::exp(exponent * squared);
      weights += weight;
      squared_weights += weight * weight;
      sum += weight * powder.velocity[other].array();
    });
    if (!(weights > 0)) continue;
    const double widening = 1 + squared_weights / (weights * weights);
    squares[k] = (powder.velocity[k].array() - sum / weights).square() / widening;
  }
  return squares;
}

}  // namespace

std::vector<Eigen::Vector3d> motion_stress_times_volume(const results::PowderState& powder,
                                                        double averaging_width) {
  if (!(averaging_width > 0)) throw std::invalid_argument("the averaging width of a field must be positive");
  const auto squares = squared_fluctuations(powder, averaging_width);
  std::vector<Eigen::Vector3d> stress;
  for (std::size_t k = 0; k < squares.size(); ++k) stress.emplace_back(-powder.mass_of(k) * squares[k]);
  return stress;
}

struct StressField::Fields {
  GaussianField trace, zz, volume;
};

StressField::StressField(const results::FillResult& result, double averaging_width) {
  const auto& powder = result.powder;
  if (powder.position.empty())
    throw std::invalid_argument("the results contain no contact stress: they hold no grains");
  if (result.contact_stress.normal.size() != powder.position.size())
    throw std::invalid_argument(
        "the results contain no contact stress: an earlier version wrote them, or this is an earlier "
        "instant; run the scene again");
  const auto motion = motion_stress_times_volume(powder, averaging_width);
  std::vector<Eigen::Vector3d> places;
  std::vector<double> trace, zz, volume;
  for (std::size_t k = 0; k < powder.position.size(); ++k) {
    if (result.solid_fraction.open[k] != 0) continue;
    const Eigen::Vector3d normal = result.contact_stress.normal[k] + motion[k];
    places.push_back(powder.position[k]);
    trace.push_back(normal.sum());
    zz.push_back(normal.z());
    volume.push_back(result.solid_fraction.cell_volume[k]);
  }
  const auto field = [&](std::vector<double> values) {
    return GaussianField::of_all_grains(places, std::move(values), powder.grain_diameter, averaging_width,
                                        period_of(powder));
  };
  fields_ = std::make_unique<Fields>(Fields{field(trace), field(zz), field(volume)});
}

StressField::~StressField() = default;

double StressField::pressure(const Eigen::Vector3d& point) const {
  return -fields_->trace.at(point) / (3 * fields_->volume.at(point));
}

double StressField::vertical(const Eigen::Vector3d& point) const {
  return -fields_->zz.at(point) / fields_->volume.at(point);
}

}  // namespace diefill::process
