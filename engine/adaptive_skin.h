// How much wider than touching the list of near pairs is: a wide list lasts longer, a narrow one holds fewer
// pairs to be tested in every step. The skin follows the powder: narrow while it rests, wide while it moves.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace diefill::engine {

/// Chooses the skin of the next list from how long the last one lasted, in steps and not in seconds, so that
/// a run can be repeated bit for bit.
class AdaptiveSkin {
 public:
  /// `fixed`: m, or 0 to adapt; `sphere_radius` in m.
  AdaptiveSkin(double fixed, double sphere_radius) : fixed_(fixed), radius_(sphere_radius) {}

  double first() const { return fixed_ > 0 ? fixed_ : kFirst * radius_; }
  double largest() const { return fixed_ > 0 ? fixed_ : kLargest * radius_; }

  /// Whether a list of `skin` (m) has lasted for so many `steps` that a narrower one would be cheaper by now.
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

 private:
  static constexpr double kFirst = 0.3, kSmallest = 0.06, kLargest = 0.6, kBalance = 40;
  double fixed_, radius_;
};

}  // namespace diefill::engine
