// How the items of a loop are shared among threads: as they turned out in the last loops. Items stay with the
// thread whose caches hold them, and slow processors get fewer.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace diefill::engine {

/// Of one loop.
class LoopShares {
 public:
  explicit LoopShares(std::size_t workers) : share_(workers, 1 / static_cast<double>(workers)) {}

  /// Calls use(worker, begin, end) with the items of [0, count) that each worker begins with.
  template <class Use>
  void divide(std::size_t count, const Use& use) const {
    double upto = 0;
    std::size_t begin = 0;
    for (std::size_t worker = 0; worker < share_.size(); ++worker) {
      upto += share_[worker];
      const auto border = static_cast<std::size_t>(std::lround(upto * static_cast<double>(count)));
      const std::size_t end = worker + 1 == share_.size() ? count : std::clamp(border, begin, count);
      use(worker, begin, end);
      begin = end;
    }
  }

  /// `worker` did `taken` of `count` items. One loop counts little: any may have met a busy processor.
  void update(std::size_t worker, std::size_t taken, std::size_t count) {
    constexpr double kWeight = 0.05;
    share_[worker] += kWeight * (static_cast<double>(taken) / static_cast<double>(count) - share_[worker]);
  }

 private:
  std::vector<double> share_;  ///< of all items
};

}  // namespace diefill::engine
