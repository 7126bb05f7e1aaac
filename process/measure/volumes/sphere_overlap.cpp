#include "process/measure/volumes/sphere_overlap.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace diefill::process {
namespace {

constexpr double kPi = std::numbers::pi;

double arc_cosine(double value) {
  return std::acos(std::clamp(value, -1.0, 1.0));
}

/// One plane face x = a of the corner x >= a, y >= b, z >= c inside the ball.
struct Face {
  double arc;   ///< rad, angle of the face's circular edge
  double area;  ///< of the face
};

Face corner_face(double a, double b, double c) {
  const double radius_squared = 1 - a * a;
  const double far_z = std::sqrt(std::max(0.0, radius_squared - b * b));
  const double far_y = std::sqrt(std::max(0.0, radius_squared - c * c));
  // Angle from (far_y, c) to (b, far_z) seen from the middle of the circle.
  const double arc = std::atan2(far_z, b) - std::atan2(c, far_y);
  return {arc, 0.5 * (radius_squared * arc - b * (far_z - c) - c * (far_y - b))};
}

/// Angle by which the edge of the corner's spherical surface turns where the planes x = a and y = b meet.
double turn(double a, double b) {
  return arc_cosine(-a * b / std::sqrt((1 - a * a) * (1 - b * b)));
}

/// For a, b, c >= 0 with the corner point inside the ball.
double corner_volume(double a, double b, double c) {
  const Face x = corner_face(a, b, c), y = corner_face(b, c, a), z = corner_face(c, a, b);
  const double turns = turn(a, b) + turn(b, c) + turn(c, a);
  const double surface = 2 * kPi - a * x.arc - b * y.arc - c * z.arc - turns;
  return std::max(0.0, (surface - a * x.area - b * y.area - c * z.area) / 3);
}

/// Length that the interval -half .. half shares with from .. to, all as angles that come round.
double shared_angle(double half, double from, double to) {
  double shared = 0;
  for (const double turned : {-2 * kPi, 0.0, 2 * kPi})
    shared += std::max(0.0, std::min(half, to + turned) - std::max(-half, from + turned));
  return shared;
}

bool is_between(double angle, double from, double to) {
  for (const double turned : {-2 * kPi, 0.0, 2 * kPi})
    if (angle + turned >= from && angle + turned <= to) return true;
  return false;
}

/// Ends of the pieces that a circle and two rays cut the edge of a disc into.
class EdgeCuts {
 public:
  EdgeCuts(double distance, double disc_radius) : distance_(distance), radius_(disc_radius) {
    add(-kPi);
    add(kPi);
  }

  void cut_by_circle(double circle_radius) {
    const double cosine = (circle_radius * circle_radius - distance_ * distance_ - radius_ * radius_) /
                          (2 * distance_ * radius_);
    if (!(std::abs(cosine) < 1)) return;
    add(std::acos(cosine));
    add(-std::acos(cosine));
  }

  void cut_by_ray(double angle) {
    const double across = distance_ * std::sin(angle), along = distance_ * std::cos(angle);
    if (!(std::abs(across) < radius_)) return;
    const double half_chord = std::sqrt((radius_ - across) * (radius_ + across));
    for (const double place : {along - half_chord, along + half_chord})
      if (place > 0) add(std::atan2(place * std::sin(angle), place * std::cos(angle) - distance_));
  }

  /// Calls `piece(start, end)` from -pi to pi.
  template <class Piece>
  void for_each_piece(Piece piece) {
    std::sort(cuts_.begin(), cuts_.begin() + count_);
    for (int k = 0; k + 1 < count_; ++k) piece(cuts_[k], cuts_[k + 1]);
  }

 private:
  void add(double angle) { cuts_[count_++] = angle; }

  double distance_, radius_;
  std::array<double, 8> cuts_{};
  int count_ = 0;
};

}  // namespace

double ball_beyond(double a) {
  if (a >= 1) return 0;
  if (a <= -1) return 4 * kPi / 3;
  return kPi * (1 - a) * (1 - a) * (2 + a) / 3;
}

double ball_beyond(double a, double b) {
  if (a >= 1 || b >= 1) return 0;
  if (a < 0) return ball_beyond(b) - ball_beyond(-a, b);
  if (b < 0) return ball_beyond(a) - ball_beyond(a, -b);
  return a * a + b * b < 1 ? 2 * corner_volume(a, b, 0) : 0;
}

double ball_beyond(double a, double b, double c) {
  if (a >= 1 || b >= 1 || c >= 1) return 0;
  if (a < 0) return ball_beyond(b, c) - ball_beyond(-a, b, c);
  if (b < 0) return ball_beyond(a, c) - ball_beyond(a, -b, c);
  if (c < 0) return ball_beyond(a, b) - ball_beyond(a, b, -c);
  return a * a + b * b + c * c < 1 ? corner_volume(a, b, c) : 0;
}

double disc_in_sector(double distance, double disc_radius, double circle_radius, double from, double to) {
  constexpr double kConcentric = 1e-13;  // of the disc's radius
  if (!(disc_radius > 0) || !(circle_radius > 0)) return 0;
  if (distance <= kConcentric * disc_radius)
    return 0.5 * std::pow(std::min(disc_radius, circle_radius), 2) * (to - from);
  // Area by Green's theorem over the edge: the rays run through the origin and contribute nothing.
  const double cosine = (circle_radius * circle_radius + distance * distance - disc_radius * disc_radius) /
                        (2 * distance * circle_radius);
  double twice = circle_radius * circle_radius * shared_angle(arc_cosine(cosine), from, to);
  EdgeCuts cuts(distance, disc_radius);
  cuts.cut_by_circle(circle_radius);
  cuts.cut_by_ray(from);
  cuts.cut_by_ray(to);
  cuts.for_each_piece([&](double start, double end) {
    const double middle = 0.5 * (start + end);
    const double x = distance + disc_radius * std::cos(middle), y = disc_radius * std::sin(middle);
    if (x * x + y * y > circle_radius * circle_radius || !is_between(std::atan2(y, x), from, to)) return;
    twice += disc_radius * disc_radius * (end - start) +
             distance * disc_radius * (std::sin(end) - std::sin(start));
  });
  return std::max(0.0, 0.5 * twice);
}

}  // namespace diefill::process
