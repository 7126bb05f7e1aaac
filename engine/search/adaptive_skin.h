// The skin: how much wider than touching the neighbour list is. A wide list lasts longer, a narrow one
// holds fewer pairs to test in every step. The skin follows the powder: narrow at rest, wide in motion. A
// grain that is faster than most may move farther than they before the list is rebuilt, so a few falling
// grains do not use up the list of all.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace diefill::engine {

/// Chooses the skin of the next list from how long the last one lasted, in steps, not in seconds, so that a
/// run can be repeated bit for bit.
class AdaptiveSkin {
 public:
  /// How often half the smallest skin fits into what a fast grain may move.
  static constexpr std::uint8_t kMaxDoublings = 7;

  /// `fixed`: m, or 0 to adapt; `sphere_radius` in m. `room`: m, how far a fast grain may move at most.
  AdaptiveSkin(double fixed, double sphere_radius, double room = 1e300)
      : fixed_(fixed), radius_(sphere_radius), room_(room) {}

  double first() const { return fixed_ > 0 ? fixed_ : kFirst * radius_; }
  double largest() const { return fixed_ > 0 ? fixed_ : kLargest * radius_; }
  /// m, farthest that any grain or tool may move before the list must be rebuilt.
  double largest_allowance() const {
    return std::max(0.5 * largest(), fixed_ > 0 ? 0 : std::min(kFarthest * radius_, room_));
  }

  /// m, how far two groups of grains may drift past each other at most; 0 where grains are not to be grouped.
  /// With largest_grouped_allowance() of two grains it is no more than grains of one group may approach, and
  /// with that of one grain no more than wall spheres are searched for.
  double largest_passing() const {
    if (fixed_ > 0 || largest_grouped_allowance() < 0.5 * largest()) return 0;
    return std::min(1.5 * largest_allowance(), 2 * room_ - 2 * largest_grouped_allowance());
  }
  /// m, farthest that a grain may move against the drift of its group.
  double largest_grouped_allowance() const { return 0.5 * largest_allowance(); }

  /// Whether a list of `skin` (m) has lasted so many `steps` that a narrower one would be cheaper now.
  bool is_too_wide(double skin, std::uint64_t steps) const {
    return fixed_ <= 0 && skin > kSmallest * radius_ &&
           skin * static_cast<double>(steps) > 4 * kBalance * radius_;
  }

  /// Skin (m) after one of `skin` that motion used up in `steps` steps. Tests of pairs that do not touch cost
  /// in proportion to the skin, searches in inverse proportion to the steps they last; both together cost
  /// least where they are equal, at skin x steps = kBalance radii: an estimate from one bed of clumps, where
  /// a search took 0.35 us a sphere and pairs grew by two a sphere for each radius of skin.
  double next(double skin, std::uint64_t steps) const {
    if (fixed_ > 0) return fixed_;
    const double lasted = std::max(1.0, static_cast<double>(steps));
    const double change = std::sqrt(kBalance * radius_ / (skin * lasted));
    return std::clamp(skin * std::clamp(change, 0.5, 2.0), kSmallest * radius_, kLargest * radius_);
  }

  /// m, how far something that moves by `step_length` (m) in a step comes in the steps that a list of `skin`
  /// (m) should last, and some more.
  double expected_displacement(double skin, double step_length) const {
    return kSpare * step_length * kBalance * radius_ / skin;
  }

  /// How often half the `skin` (m) is to be doubled for something that moves by `step_length` (m) in a step:
  /// enough for its expected displacement, but not beyond `largest` (m).
  std::uint8_t doublings(double skin, double step_length, double largest) const {
    if (fixed_ > 0) return 0;
    const double expected = expected_displacement(skin, step_length);
    std::uint8_t count = 0;
    for (double allowance = 0.5 * skin;
         count < kMaxDoublings && allowance < expected && 2 * allowance <= largest; allowance *= 2)
      ++count;
    return count;
  }
  std::uint8_t doublings(double skin, double step_length) const {
    return doublings(skin, step_length, largest_allowance());
  }

 private:
  static constexpr double kFirst = 0.3, kSmallest = 0.06, kLargest = 0.6, kBalance = 40;
  static constexpr double kFarthest = 2, kSpare = 1.25;
  double fixed_, radius_, room_;
};

}  // namespace diefill::engine
