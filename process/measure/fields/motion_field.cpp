#include "process/measure/fields/motion_field.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <unordered_map>

#include "process/measure/cavity_position.h"
#include "process/measure/fields/gaussian_field.h"
#include "process/measure/fields/plane_sample.h"
#include "process/measure/volumes/partial_volumes.h"

namespace diefill::process {
namespace {

constexpr double kMillimetre = 1e-3;
constexpr double kArrowSpacing = 3;  // sigma

/// The three components of a vector as averaged fields.
class VectorField {
 public:
  VectorField(const GrainVectors& grains, double grain_diameter, double averaging_width,
              const Period& period = {}) {
    for (int axis = 0; axis < 3; ++axis) {
      std::vector<double> values;
      for (const auto& vector : grains.vector) values.push_back(vector[axis]);
      components_.push_back(
          GaussianField::of_all_grains(grains.place, values, grain_diameter, averaging_width, period));
    }
  }

  Eigen::Vector3d at(const Eigen::Vector3d& point) const {
    return {components_[0].at(point), components_[1].at(point), components_[2].at(point)};
  }

 private:
  std::vector<GaussianField> components_;
};

/// Mean over radii of a ring, as components along azimuth, height and radius; NaN where no radius has powder.
Eigen::Vector3d ring_mean(const VectorField& field, const results::CavityState& cavity, double azimuth,
                          double height) {
  constexpr int kRadii = 3;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  int found = 0;
  for (int n = 0; n < kRadii; ++n) {
    const double radius =
        cavity.inner_radius + (n + 0.5) / kRadii * (cavity.outer_radius - cavity.inner_radius);
    const Eigen::Vector3d point = ring_point(cavity, {azimuth, radius, height});
    const Eigen::Vector3d value = field.at(point);
    if (!value.allFinite()) continue;
    Eigen::Vector3d outward = point - cavity.axis_origin;
    outward.z() = 0;
    outward.normalize();
    const Eigen::Vector3d round(-outward.y(), outward.x(), 0);
    sum += Eigen::Vector3d(value.dot(round), value.z(), value.dot(outward));
    ++found;
  }
  const double none = std::numeric_limits<double>::quiet_NaN();
  return found > 0 ? Eigen::Vector3d(sum / found) : Eigen::Vector3d::Constant(none);
}

/// m, the shortest way from one place to another in a box with these periods: grains that have left it come
/// back at the other side.
Eigen::Vector3d way_between(const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                            const std::array<double, 3>& period) {
  Eigen::Vector3d way = to - from;
  for (int axis = 0; axis < 3; ++axis) {
    const double length = period[static_cast<std::size_t>(axis)];
    if (length > 0) way[axis] -= length * std::round(way[axis] / length);
  }
  return way;
}

int count_of(double length, double spacing, int least, int most) {
  return std::clamp(static_cast<int>(std::lround(length / spacing)), least, most);
}

}  // namespace

GrainVectors velocities(const results::PowderState& powder) {
  return {powder.position, powder.velocity};
}

GrainVectors displacements(const results::PowderState& before, const results::PowderState& after,
                           const results::CavityState& cavity) {
  std::unordered_map<std::uint64_t, std::size_t> later;
  for (std::size_t k = 0; k < after.id.size(); ++k) later.emplace(after.id[k], k);
  GrainVectors grains;
  for (std::size_t k = 0; k < before.id.size(); ++k) {
    const auto found = later.find(before.id[k]);
    if (found == later.end() || !lies_in_cavity(cavity, before.position[k]) ||
        !lies_in_cavity(cavity, after.position[found->second]))
      continue;
    grains.place.push_back(before.position[k]);
    grains.vector.push_back(way_between(before.position[k], after.position[found->second], after.period) /
                            kMillimetre);
  }
  return grains;
}

results::ArrowField unrolled_vectors(const GrainVectors& grains, const results::CavityState& cavity,
                                     double grain_diameter, double averaging_width) {
  const double depth = cavity.upper_corner.z() - cavity.lower_corner.z();
  if (!cavity.is_ring || !(depth > 0) || !(cavity.outer_radius > cavity.inner_radius))
    throw std::invalid_argument("an unrolled map needs a ring with a depth and two radii");
  const double round = std::numbers::pi * (cavity.inner_radius + cavity.outer_radius);
  const VectorField field(grains, grain_diameter, averaging_width);
  results::ArrowField map;
  map.field = {"magnitude", "azimuth", "deg", "height", "mm", {}, {}, {}, averaging_width};
  map.field.first = even_edges(0, 360, count_of(round, 0.5 * averaging_width, 36, 360));
  map.field.second = even_edges(0, depth / kMillimetre, count_of(depth, 0.5 * averaging_width, 4, 160));
  for (const double height : map.field.second)
    for (const double azimuth : map.field.first)
      map.field.value.push_back(ring_mean(field, cavity, azimuth, height * kMillimetre).norm());
  const int columns = count_of(round, kArrowSpacing * averaging_width, 12, 60);
  const int rows = count_of(depth, kArrowSpacing * averaging_width, 3, 24);
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      const double azimuth = (i + 0.5) * 360 / columns, height = (j + 0.5) * depth / rows;
      const Eigen::Vector3d mean = ring_mean(field, cavity, azimuth, height);
      if (mean.allFinite()) map.arrows.push_back({azimuth, height / kMillimetre, mean.x(), mean.y()});
    }
  return map;
}

results::ArrowField plane_vectors(const GrainVectors& grains, const results::FillResult& result,
                                  const results::SectionPlane& plane, double averaging_width) {
  const VectorField field(grains, result.powder.grain_diameter, averaging_width, period_of(result.powder));
  results::ArrowField map;
  map.field = sample_plane(result.powder, result.solid_fraction, result.tools, plane, averaging_width,
                           [&](const Eigen::Vector3d& point) { return field.at(point).norm(); })
                  .field;
  if (map.field.first.empty()) return map;
  map.field.quantity = std::string("magnitude");
  const double step = map.field.first[1] - map.field.first[0];
  const auto every = static_cast<std::size_t>(
      std::max(1.0, std::round(kArrowSpacing * averaging_width / kMillimetre / step)));
  for (std::size_t j = every / 2; j < map.field.second.size(); j += every)
    for (std::size_t i = every / 2; i < map.field.first.size(); i += every) {
      if (std::isnan(map.field.value[j * map.field.first.size() + i])) continue;
      const double first = map.field.first[i], second = map.field.second[j];
      const Eigen::Vector3d value =
          field.at(plane.origin + kMillimetre * (first * plane.first_axis + second * plane.second_axis));
      map.arrows.push_back({first, second, value.dot(plane.first_axis), value.dot(plane.second_axis)});
    }
  return map;
}

}  // namespace diefill::process
