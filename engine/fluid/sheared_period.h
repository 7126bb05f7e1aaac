// A periodic box that is sheared (Lees and Edwards 1972): what is seen beyond its borders along y is
// displaced along x, farther with time, and moves along x. Without walls the powder or fluid in it flows with
// a linear profile.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "engine/powder/grains.h"
#include "engine/powder/periodic_box.h"

namespace diefill::engine {

/// Where the images of a sheared box are at one time.
class ShearedPeriod {
 public:
  /// Lengths in m, rate in 1/s: velocity along x over y. Throws std::invalid_argument for a rate where x or y
  /// has no period.
  ShearedPeriod(const PeriodLengths& period, double rate);

  bool shears() const { return rate_ != 0; }
  double rate() const { return rate_; }
  /// m/s along x, of the image one period up along y against its owner.
  double speed() const { return speed_; }
  /// m along x, the same image's displacement at `time` (s) since the start.
  double offset(double time) const { return speed_ * time; }
  /// m, how far images move along x in `duration` (s) beside their owners' own motion.
  double drift(double duration) const { return std::abs(speed_) * duration; }

  /// Puts what has left the box back into it, at `time`: what leaves along y changes velocity, too.
  void wrap(Grains& grains, double time) const;
  /// m: the place of the point that stands for `point` nearest to `near`, at `time`; `velocity` (m/s) becomes
  /// the one there.
  Eigen::Vector3d nearest(Eigen::Vector3d point, const Eigen::Vector3d& near, double time,
                          Eigen::Vector3d& velocity) const;

  /// The search knows whole numbers of periods along each axis. A sheared box shows it periods along x of
  /// this share, so that displaced images are at most half of one away from where the search sees them.
  static constexpr int kPartsOfPeriod = 80;
  /// The box that the search sees.
  PeriodicBox searched() const;
  /// m, how far an image may be from where the search sees it.
  double search_error() const { return shears() ? 0.5 * *period_[0] / kPartsOfPeriod : 0; }

  /// Finds the images of all `positions` (m, in the box) within `margin` (m) of its borders at `time`, and
  /// appends them as the search sees them.
  void find_images(const std::vector<Eigen::Vector3d>& positions, double margin, double time,
                   std::vector<GrainImage>& images);
  /// An image at one time, from its owner.
  struct Shift {
    Vector3 place;     ///< m
    Vector3 velocity;  ///< m/s
  };
  /// Of image k of those that were found last.
  Shift shift(std::size_t k, const GrainImage& image, double time) const;

 private:
  void add_row(std::uint32_t owner, const Eigen::Vector3d& point, double margin, int over_y, int over_z,
               std::vector<GrainImage>& images);

  PeriodLengths period_;
  double rate_ = 0, speed_ = 0;
  double found_at_ = 0;              ///< s
  double found_offset_ = 0;          ///< m, of one period up, between -1/2 and 1/2 of a period along x
  std::vector<std::int8_t> over_x_;  ///< periods along x of each image, beside the offset
};

}  // namespace diefill::engine
