// Long ranges divided among threads: into consecutive runs, or into shares of values. The result does not
// depend on which thread does what.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "engine/numerics/thread_pool.h"

namespace diefill::engine {

/// How many runs of up to `length` there are in [0, count).
inline std::size_t runs_in(std::size_t count, std::size_t length) {
  return (count + length - 1) / length;
}

/// Calls use(begin, end, run) for the runs of up to `length` in [0, count).
template <class Use>
void in_runs(std::size_t count, std::size_t length, ThreadPool& pool, const Use& use) {
  pool.for_each(runs_in(count, length),
                [&](std::size_t run) { use(run * length, std::min(count, (run + 1) * length), run); });
}

/// Values from `begin` on, `width` of them.
struct Share {
  std::uint32_t begin, width;
  /// Lower values wrap round to large ones: one comparison does for both ends.
  bool has(std::uint32_t value) const { return value - begin < width; }
};

/// Calls use(share) for [0, count) divided into `shares`: a thread that visits all members and takes those of
/// its share keeps their order without asking other threads.
template <class Use>
void in_shares(std::size_t count, std::size_t shares, ThreadPool& pool, const Use& use) {
  pool.for_each(shares, [&](std::size_t share) {
    const auto begin = static_cast<std::uint32_t>(count * share / shares);
    use(Share{begin, static_cast<std::uint32_t>(count * (share + 1) / shares) - begin});
  });
}

}  // namespace diefill::engine
