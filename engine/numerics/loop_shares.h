// How the items of a loop are shared among threads: as they came to be last time. Items stay with the thread
// whose caches hold them, and slow processors get fewer.
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

  /// First item of each worker, and behind the last one `count`.
  std::vector<std::size_t> borders(std::size_t count) const {
    std::vector<std::size_t> borders;
    borders.reserve(share_.size() + 1);
    borders.push_back(0);
    double upto = 0;
    for (const double share : share_) {
      upto += share;
      const auto border = static_cast<std::size_t>(std::lround(upto * static_cast<double>(count)));
      borders.push_back(std::clamp(border, borders.back(), count));
    }
    borders.back() = count;
    return borders;
  }

  /// `worker` did `taken` of `count` items. One loop counts little: any may have met a busy processor.
  void remember(std::size_t worker, std::size_t taken, std::size_t count) {
    constexpr double kWeight = 0.05;
    share_[worker] += kWeight * (static_cast<double>(taken) / static_cast<double>(count) - share_[worker]);
  }

 private:
  std::vector<double> share_;  ///< of all items
};

}  // namespace diefill::engine
