// Stress in the powder as a smooth field.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <string>
#include <vector>

#include "process/results/fill_result.h"

namespace diefill::process {

/// Stress of grains averaged over their surroundings: sum of stress times volume over sum of cell volumes,
/// both weighted as in Bierwisch 2009, Eq. 2.27. Stress is that of Eq. 3.8: what contacts carry, and the
/// grains' motion against the mean velocity around them; the volume is that of the grain's Voronoi cell, so
/// that this is the stress of the bulk. Only closed cells enter.
class StressField {
 public:
  /// `averaging_width`: sigma in m. Throws std::invalid_argument where the results hold no contact stress.
  StressField(const results::FillResult& result, double averaging_width);
  ~StressField();

  /// Pa: a third of the trace with the sign of a pressure, compression positive; NaN where no powder is.
  double pressure(const Eigen::Vector3d& point) const;
  /// Pa: what presses downwards, -sigma_zz.
  double vertical(const Eigen::Vector3d& point) const;

 private:
  struct Fields;
  std::unique_ptr<Fields> fields_;
};

/// J of every grain: the part of Eq. 3.8 (Bierwisch 2009) that stems from its motion against the mean
/// velocity of the other grains around it (weights of Eq. 2.27), diagonal only. Right on average for grains
/// that move independently of each other, whatever the width; 0 without other grains within 4 sigma. Throws
/// std::invalid_argument for a width that is not positive.
std::vector<Eigen::Vector3d> motion_stress_times_volume(const results::PowderState& powder,
                                                        double averaging_width);

}  // namespace diefill::process
