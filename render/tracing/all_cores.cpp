#include "render/tracing/all_cores.h"

#include <oneapi/tbb/parallel_for.h>

#include <atomic>

namespace diefill::render {

// oneTBB itself orders memory accesses before and after the loop; the counters show this order to the thread
// sanitizer, for which Debian's library is not built.
void on_all_cores(int count, const std::function<void(int)>& work) {
  std::atomic<int> begun = 0, ended = 0;
  begun.store(1, std::memory_order_release);
  tbb::parallel_for(0, count, [&](int n) {
    begun.load(std::memory_order_acquire);
    work(n);
    ended.fetch_add(1, std::memory_order_release);
  });
  ended.load(std::memory_order_acquire);
}

}  // namespace diefill::render
