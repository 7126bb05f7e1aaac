// Memory that each worker of a thread pool has to itself: allocated once, used again for every block that the
// worker computes.
#pragma once

#include <cstddef>
#include <vector>

namespace diefill::engine {

/// One value for each worker of a pool of `threads`. Each lies on cache lines of its own, so that workers
/// that write to theirs do not slow each other down.
template <class Value>
class PerWorker {
 public:
  explicit PerWorker(int threads) : own_(static_cast<std::size_t>(threads)) {}
  /// `worker`: as ThreadPool::for_each_by_worker() counts them.
  Value& operator[](std::size_t worker) { return own_[worker].value; }

 private:
  /// Processors fetch lines of 64 bytes in pairs.
  struct alignas(128) Own {
    Value value;
  };
  std::vector<Own> own_;
};

}  // namespace diefill::engine
