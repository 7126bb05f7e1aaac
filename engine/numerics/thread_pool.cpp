#include "engine/numerics/thread_pool.h"

#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include <atomic>

namespace diefill::engine {

namespace {

/// Tells the thread sanitizer the order that oneTBB guarantees, because Debian's library is not instrumented:
/// all before a parallel loop happens before its body, and all in its body before what follows. Costs nothing
/// in other builds.
class LoopOrder {
#ifdef __SANITIZE_THREAD__
 public:
  void begin() {
    begun_.fetch_add(1, std::memory_order_release);
  }
  void enter() {
    begun_.load(std::memory_order_acquire);
  }
  void leave() {
    ended_.fetch_add(1, std::memory_order_release);
  }
  void end() {
    ended_.load(std::memory_order_acquire);
  }

 private:
  std::atomic<unsigned> begun_{0}, ended_{0};
#else
 public:
  void begin() {}
  void enter() {}
  void leave() {}
  void end() {}
#endif
};

}  // namespace

/// oneTBB's types, kept out of the header.
class ThreadPool::Arena : public oneapi::tbb::task_arena {
 public:
  using task_arena::task_arena;
};

ThreadPool::ThreadPool(int threads) : threads_(threads), arena_(std::make_unique<Arena>(threads)) {}
ThreadPool::~ThreadPool() = default;
ThreadPool::ThreadPool(ThreadPool&&) noexcept = default;
ThreadPool& ThreadPool::operator=(ThreadPool&&) noexcept = default;

void ThreadPool::share_out(std::size_t count,
                           void (*call)(const void* action, std::size_t k, std::size_t worker),
                           const void* action) {
  LoopOrder order;
  order.begin();
  arena_->execute([&] {
    oneapi::tbb::parallel_for(
        oneapi::tbb::blocked_range<std::size_t>(0, count, 1),
        [&](const auto& range) {
          order.enter();
          const auto worker = static_cast<std::size_t>(oneapi::tbb::this_task_arena::current_thread_index());
          for (std::size_t k = range.begin(); k != range.end(); ++k) call(action, k, worker);
          order.leave();
        },
        oneapi::tbb::simple_partitioner());
  });
  order.end();
}

}  // namespace diefill::engine
