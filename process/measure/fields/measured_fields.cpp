#include "process/measure/fields/measured_fields.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "process/measure/fields/averaging_width.h"
#include "process/measure/fields/box_map.h"
#include "process/measure/figures/segregation.h"
#include "process/measure/measure.h"

namespace diefill::process {

namespace {

/// The default section, which shows most: vertical, through the middle of the cavity or of the powder, along
/// the shoe's motion.
results::SectionPlane default_section(const results::FillResult& result) {
  Eigen::Vector3d origin = result.cavity.axis_origin;
  if (result.cavity.volume <= 0) {
    origin.setZero();
    for (const auto& position : result.powder.position) origin += position;
    if (!result.powder.position.empty()) origin /= static_cast<double>(result.powder.position.size());
    origin[2] = 0;
  }
  const Eigen::Vector3d along = result.cavity.azimuth_zero;
  return section_plane(kDefaultSection, origin, Eigen::Vector3d(-along[1], along[0], 0));
}

}  // namespace

results::SectionPlane section_plane(const std::string& name, const Eigen::Vector3d& origin,
                                    const Eigen::Vector3d& normal) {
  results::SectionPlane plane;
  plane.name = name;
  plane.normal = normal.normalized();
  // Coordinates in the plane count from here: those along x, y or z are the laboratory's own.
  plane.origin = origin.dot(plane.normal) * plane.normal;
  // Upright planes are seen with z up; a horizontal one with x to the right.
  const bool horizontal = std::abs(plane.normal[2]) > 0.999;
  plane.first_axis = horizontal ? Eigen::Vector3d(Eigen::Vector3d::UnitX())
                                : Eigen::Vector3d(-Eigen::Vector3d::UnitZ().cross(plane.normal).normalized());
  if (!horizontal && plane.first_axis.sum() < 0) plane.first_axis *= -1;
  plane.second_axis =
      horizontal ? Eigen::Vector3d(Eigen::Vector3d::UnitY())
                 : Eigen::Vector3d((Eigen::Vector3d::UnitZ() - plane.normal[2] * plane.normal).normalized());
  return plane;
}

void measure_fields(results::FillResult& result, const FieldRequest& request, int azimuth_bins) {
  constexpr int kSectors = 12;
  const double width = request.averaging_width > 0 ? request.averaging_width
                                                   : default_averaging_width(result.powder.grain_diameter);
  result.maps.clear();
  result.sections.clear();
  result.profiles.clear();
  if (result.cavity.is_ring) {
    result.maps.push_back(
        cylindrical_map(result.powder, result.solid_fraction, result.tools, result.cavity, width));
    result.profiles.push_back(fill_level(result.powder, result.cavity, azimuth_bins));
    result.profiles.push_back(sector_filling(result.powder, result.solid_fraction, result.cavity, kSectors));
    result.profiles.push_back(height_profile(result.maps.back()));
    for (auto& profile : size_profiles(result)) result.profiles.push_back(std::move(profile));
  } else if (result.cavity.volume > 0) {
    result.maps.push_back(box_map(result, BoxView::kPlan, width));
    result.maps.push_back(fill_level_map(result));
    result.profiles.push_back(fill_level_along_travel(result.maps.back(), result.cavity));
    result.profiles.push_back(height_profile(box_map(result, BoxView::kSide, width)));
  }
  auto planes = request.sections;
  if (planes.empty()) planes.push_back(default_section(result));
  for (const auto& plane : planes)
    result.sections.push_back(
        plane_section(result.powder, result.solid_fraction, result.tools, plane, width));
}

}  // namespace diefill::process
