// Wall-clock time of each phase of a step; always on, so that slowdowns are located, not guessed.
#pragma once

#include <array>
#include <chrono>
#include <cstddef>

namespace diefill::engine {

enum class Phase : std::size_t { advance, search, contacts, gather, count };

/// Names of the phases for reports, in the order of Phase.
inline constexpr std::array<const char*, 4> kPhaseNames = {"advance", "search", "contacts", "gather"};

/// Adds up seconds per phase: `lap(p)` adds the time since the last lap to p.
class PhaseTimers {
 public:
  void begin() { last_ = Clock::now(); }
  void lap(Phase phase) {
    const auto now = Clock::now();
    seconds_[static_cast<std::size_t>(phase)] += std::chrono::duration<double>(now - last_).count();
    last_ = now;
  }
  /// The same where two phases alternate: `share` of the time, 0 to 1, goes to the second.
  void lap(Phase first, Phase second, double share) {
    const double before = seconds_[static_cast<std::size_t>(first)];
    lap(first);
    const double moved = share * (seconds_[static_cast<std::size_t>(first)] - before);
    seconds_[static_cast<std::size_t>(first)] -= moved;
    seconds_[static_cast<std::size_t>(second)] += moved;
  }
  const std::array<double, 4>& seconds() const { return seconds_; }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point last_;
  std::array<double, 4> seconds_{};
};

}  // namespace diefill::engine
