#include "process/measure/fields/stress_field.h"

#include <stdexcept>

#include "process/measure/fields/gaussian_field.h"

namespace diefill::process {
namespace {

/// One component of all grains' velocities, averaged, where the grains are.
std::vector<double> mean_velocity(const results::PowderState& powder, int axis, double averaging_width) {
  std::vector<double> velocity;
  for (const auto& grain : powder.velocity) velocity.push_back(grain[axis]);
  const auto field = GaussianField::of_all_grains(powder.position, velocity, powder.grain_diameter,
                                                  averaging_width, period_of(powder));
  std::vector<double> mean;
  for (const auto& place : powder.position) mean.push_back(field.at(place));
  return mean;
}

}  // namespace

std::vector<Eigen::Vector3d> motion_stress_times_volume(const results::PowderState& powder,
                                                        double averaging_width) {
  std::vector<Eigen::Vector3d> stress(powder.position.size(), Eigen::Vector3d::Zero());
  for (int axis = 0; axis < 3; ++axis) {
    const auto mean = mean_velocity(powder, axis, averaging_width);
    for (std::size_t k = 0; k < stress.size(); ++k) {
      const double against_mean = powder.velocity[k][axis] - mean[k];
      stress[k][axis] = -powder.mass_of(k) * against_mean * against_mean;
    }
  }
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
