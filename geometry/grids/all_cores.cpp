#include "geometry/grids/all_cores.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <atomic>

namespace diefill::geometry {

// oneTBB itself orders what is written before and after. Debian's library is not built for the thread
// sanitizer, which learns the order from the two counters; their cost is negligible.
void on_all_cores(std::size_t count, const std::function<void(std::size_t)>& work) {
  std::atomic<std::size_t> begun = 0, ended = 0;
  begun.store(1, std::memory_order_release);
  tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) {
    begun.load(std::memory_order_acquire);
    work(i);
    ended.fetch_add(1, std::memory_order_release);
  });
  ended.load(std::memory_order_acquire);
}

void in_parts_on_all_cores(std::size_t count, const std::function<void(std::size_t, std::size_t)>& work) {
  constexpr std::size_t kPart = 16384;
  on_all_cores((count + kPart - 1) / kPart,
               [&](std::size_t part) { work(part * kPart, std::min(count, (part + 1) * kPart)); });
}

void side_by_side(const std::function<void()>& one, const std::function<void()>& other) {
  const std::array both = {&one, &other};
  on_all_cores(both.size(), [&](std::size_t i) { (*both[i])(); });
}

}  // namespace diefill::geometry
