#include "process/laboratory/flow/hopper_models.h"

#include <algorithm>
#include <cmath>

namespace diefill::process::laboratory {

double local_length(const HopperFields& fields, int column, int row) {
  const double slope =
      (fields.at(fields.vertical, column + 1, row) - fields.at(fields.vertical, column - 1, row)) /
      (2 * fields.grid.spacing_x());
  const double length = -fields.at(fields.horizontal, column, row) / slope;
  return std::isfinite(length) ? length : std::nan("");
}

std::vector<continuum::LengthPoint> local_lengths(const HopperFields& fields, double least) {
  std::vector<continuum::LengthPoint> points;
  const auto& grid = fields.grid;
  for (int row = 1; row <= grid.rows; ++row)
    for (int c = 1; c + 1 < grid.columns; ++c) {
      const double speed = fields.at(fields.horizontal, c, row);
      const double fraction = fields.at(fields.fraction, c, row);
      if (!(std::abs(speed) > least) || !std::isfinite(fraction)) continue;
      const double length = local_length(fields, c, row);
      if (length > 0) points.push_back({fraction, length, 1});
    }
  return points;
}

std::vector<LengthClass> in_classes(const std::vector<continuum::LengthPoint>& points, int classes) {
  if (points.empty()) return {};
  const auto [low, high] =
      std::minmax_element(points.begin(), points.end(),
                          [](const auto& one, const auto& other) { return one.fraction < other.fraction; });
  const double begin = low->fraction, width = (high->fraction - begin) / classes;
  std::vector<LengthClass> found(classes);
  for (const auto& point : points) {
    const int k = width > 0 ? std::min(classes - 1, static_cast<int>((point.fraction - begin) / width)) : 0;
    found[k].fraction += point.fraction;
    found[k].mean += point.length;
    found[k].deviation += point.length * point.length;
    found[k].count += 1;
  }
  std::erase_if(found, [](const LengthClass& one) { return one.count < 10; });
  for (LengthClass& one : found) {
    one.fraction /= one.count;
    one.mean /= one.count;
    one.deviation = std::sqrt(std::max(0.0, one.deviation / one.count - one.mean * one.mean));
  }
  return found;
}

continuum::HopperFlow solve_for(const HopperFields& fields, double slit,
                                const continuum::DiffusionLength& length, bool compressible) {
  std::vector<double> opening;
  for (int c = 0; c < fields.grid.columns; ++c) {
    const double speed = fields.at(fields.vertical, c, 0);
    const bool open = std::abs(fields.grid.x(c)) < slit / 2;
    opening.push_back(open && std::isfinite(speed) ? std::min(0.0, speed) : 0);
  }
  std::vector<double> fraction;
  if (compressible) {
    fraction = fields.fraction;
    for (double& value : fraction)
      if (!std::isfinite(value)) value = fields.bulk_fraction;
  }
  return continuum::solve_kinematic(fields.grid, opening, length, fraction);
}

ModelError error_of(const continuum::HopperFlow& flow, const HopperFields& fields, double from, double to) {
  double apart_z = 0, all_z = 0, apart_x = 0, all_x = 0;
  const auto& grid = fields.grid;
  for (int row = 0; row <= grid.rows; ++row) {
    const double z = row * grid.spacing_z();
    if (z < from || z > to) continue;
    for (int c = 0; c < grid.columns; ++c) {
      const double vertical = fields.at(fields.vertical, c, row);
      const double horizontal = fields.at(fields.horizontal, c, row);
      if (!std::isfinite(vertical)) continue;
      const double lateral = 0.5 * (flow.horizontal_at(c, row) + flow.horizontal_at(c + 1, row));
      apart_z += std::pow(flow.vertical_at(c, row) - vertical, 2);
      apart_x += std::pow(lateral - horizontal, 2);
      all_z += vertical * vertical;
      all_x += horizontal * horizontal;
    }
  }
  return {std::sqrt(apart_z / all_z), std::sqrt(apart_x / all_x)};
}

}  // namespace diefill::process::laboratory
