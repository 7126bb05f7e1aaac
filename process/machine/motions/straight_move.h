// A move along a line from rest to rest: constant acceleration, constant velocity, constant deceleration.
#pragma once

namespace diefill::process {

/// Position and velocity of such a move in closed form. A distance too short to reach the velocity gives a
/// move that brakes as soon as it is half way.
class StraightMove {
 public:
  /// `distance` in m, `velocity` in m/s, `acceleration` in m/s^2, all positive; throws std::invalid_argument
  /// otherwise.
  StraightMove(double distance, double velocity, double acceleration);

  double duration() const { return duration_; }  ///< s
  /// m travelled at `time` (s since the start); 0 before the start, the distance after the end.
  double position(double time) const;
  /// m/s at `time`; 0 before the start and after the end.
  double velocity(double time) const;

 private:
  double distance_, acceleration_, peak_velocity_, ramp_time_, duration_;
};

}  // namespace diefill::process
