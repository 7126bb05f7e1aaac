// The smooth field of grains' values: a Gaussian average over grain centres (Bierwisch 2009, Eq. 2.27).
#pragma once

#include <vector>

#include "geometry/voronoi/neighbour_grid.h"
#include "process/measure/period.h"

namespace diefill::process {

/// Weights beyond this many sigma are below 4e-4 and not counted.
inline constexpr double kReachOverWidth = 4;

/// rho(r) = sum_k rho_k w_k / sum_k w_k, w_k = exp(-(r - r_k)^2 / 2 sigma^2) (Bierwisch 2009, Eq. 2.27), over
/// grains within kReachOverWidth sigma. Where no grain centre is within the hole distance there is no powder
/// to speak of and no value.
class GaussianField {
 public:
  /// Solid fraction of the grains whose cells are closed. `averaging_width` is sigma in m and must be
  /// positive (std::invalid_argument). The hole distance is the larger of 1.2 d and 1.5 sigma: no point in a
  /// random packing is as far as that from the next centre, while a bridged-over hole is.
  GaussianField(const results::PowderState& powder, const results::GrainSolidFraction& fraction,
                double averaging_width);

  /// Any value of all grains, closed cells or not; `values` one per grain.
  static GaussianField of_all_grains(const std::vector<Eigen::Vector3d>& centres, std::vector<double> values,
                                     double grain_diameter, double averaging_width,
                                     const Period& period = {});

  /// Value at `point` (m, laboratory frame), NaN in holes and outside the powder.
  double at(const Eigen::Vector3d& point) const;

  /// The same without regard to holes: NaN only where no grain is within reach of the average. For places
  /// that are known to hold powder (powder_places.h).
  double mean_at(const Eigen::Vector3d& point) const;

 private:
  struct Source {
    std::vector<Eigen::Vector3d> centres;
    std::vector<double> values;
  };
  GaussianField(Source source, double averaging_width, double hole);
  double value(const Eigen::Vector3d& point, double hole) const;
  static Source closed_grains(const results::PowderState& powder, const results::GrainSolidFraction& fraction,
                              double margin);
  static Source with_images(Source source, double margin, const Period& period);

  double averaging_width_, hole_, reach_;
  std::vector<double> values_;
  geometry::NeighbourGrid grid_;
};

}  // namespace diefill::process
