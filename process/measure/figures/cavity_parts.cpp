#include "process/measure/figures/cavity_parts.h"

#include <cmath>

#include "process/measure/cavity_position.h"

namespace diefill::process {
namespace {

constexpr double kQuarter = 45;  // deg to either side

bool shoe_moves(const results::FillResult& result) {
  const auto speed = result.figures.find("shoe_speed_m_s");
  return speed != result.figures.end() && std::isfinite(speed->second);
}

std::string end_text(const Eigen::Vector3d& direction) {
  const int axis = std::abs(direction.x()) >= std::abs(direction.y()) ? 0 : 1;
  return std::string("at the end towards ") + (direction[axis] < 0 ? "-" : "+") + (axis == 0 ? "x" : "y");
}

}  // namespace

std::vector<CavityPart> horizontal_parts(const results::FillResult& result) {
  const auto& cavity = result.cavity;
  const bool shoe = shoe_moves(result);
  const std::string first = shoe ? "where the shoe arrives" : end_text(cavity.azimuth_zero),
                    last = shoe ? "where the shoe leaves" : end_text(-cavity.azimuth_zero);
  if (cavity.is_ring) {
    const auto off = [cavity](const Eigen::Vector3d& place) {
      return std::abs(std::remainder(ring_position(cavity, place).azimuth, 360));
    };
    return {{first, [off](const Eigen::Vector3d& place) { return off(place) <= kQuarter; }},
            {"at the sides",
             [off](const Eigen::Vector3d& place) {
               return off(place) > kQuarter && off(place) < 180 - kQuarter;
             }},
            {last, [off](const Eigen::Vector3d& place) { return off(place) >= 180 - kQuarter; }}};
  }
  const auto third = [cavity](const Eigen::Vector3d& place) { return 3 * along_travel(cavity, place); };
  return {
      {first, [third](const Eigen::Vector3d& place) { return third(place) < 1; }},
      {"in the middle",
       [third](const Eigen::Vector3d& place) { return third(place) >= 1 && third(place) < 2; }},
      {last, [third](const Eigen::Vector3d& place) { return third(place) >= 2; }},
  };
}

std::vector<CavityPart> vertical_parts(const results::FillResult& result) {
  const double floor = result.cavity.lower_corner.z(), depth = result.cavity.upper_corner.z() - floor;
  const auto third = [=](const Eigen::Vector3d& place) { return 3 * (place.z() - floor) / depth; };
  return {
      {"at the bottom", [third](const Eigen::Vector3d& place) { return third(place) < 1; }},
      {"at half height",
       [third](const Eigen::Vector3d& place) { return third(place) >= 1 && third(place) < 2; }},
      {"at the top", [third](const Eigen::Vector3d& place) { return third(place) >= 2; }},
  };
}

}  // namespace diefill::process
