// Distribution of large and small grains: mean grain diameters, weighted by mass, over the cavity. They show
// strategies that segregate; powder of one size has none.
#pragma once

#include <memory>

#include "process/measure/fields/gaussian_field.h"
#include "process/results/fill_result.h"

namespace diefill::process {

/// Mean diameter (mm) of the grains whose centre lies in the cavity, weighted by mass, over height (mm above
/// the cavity floor) and, in rings, over azimuth (deg); NaN where a bin has fewer than three grains. Nothing
/// for powder of one size or there is no cavity.
std::vector<results::Profile> size_profiles(const results::FillResult& result);

/// The mean diameter as a field: Gaussian averages (gaussian_field.h) of diameter times mass over mass, of
/// all grains. Throws std::invalid_argument for powder of one size.
class SizeField {
 public:
  SizeField(const results::PowderState& powder, double averaging_width);
  /// mm at `point` (m, laboratory frame), NaN where there is no powder.
  double at(const Eigen::Vector3d& point) const;

 private:
  GaussianField moment_, mass_;
};

/// Lacey's mixing index of the diameters `values` with masses `weights`, in bins numbered by `bins`: (s0^2 -
/// s^2) / (s0^2 - sr^2), s^2 the variance of the bins' means, s0^2 that of fully separated grains, sr^2 what
/// chance alone leaves in bins of so many grains (Lacey 1954, with weights in place of numbers). About 1:
/// mixed as well as by chance; 0: each size on its own. NaN for fewer than two bins with grains, or grains
/// that are all alike.
double mixing_index(const std::vector<double>& values, const std::vector<double>& weights,
                    const std::vector<std::size_t>& bins);

}  // namespace diefill::process
