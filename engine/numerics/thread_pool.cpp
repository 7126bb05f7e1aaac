#include "engine/numerics/thread_pool.h"

#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include <atomic>
#include <chrono>
#include <optional>

#include "engine/numerics/per_worker.h"

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

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

}  // namespace

/// oneTBB's types, kept out of the header, and the times of its loops where they are wanted.
class ThreadPool::Arena : public oneapi::tbb::task_arena {
 public:
  using task_arena::task_arena;

  double loops = 0;
  std::optional<PerWorker<double>> busy;
};

ThreadPool::ThreadPool(int threads) : threads_(threads), arena_(std::make_unique<Arena>(threads)) {}
ThreadPool::~ThreadPool() = default;
ThreadPool::ThreadPool(ThreadPool&&) noexcept = default;
ThreadPool& ThreadPool::operator=(ThreadPool&&) noexcept = default;

void ThreadPool::time_loops() {
  arena_->loops = 0;
  arena_->busy.emplace(threads_);
}

LoopTimes ThreadPool::loop_times() const {
  LoopTimes times;
  if (!arena_->busy) return times;
  times.loops = arena_->loops;
  for (int worker = 0; worker < threads_; ++worker)
    times.busy.push_back((*arena_->busy)[static_cast<std::size_t>(worker)]);
  return times;
}

void ThreadPool::share_out(std::size_t count,
                           void (*call)(const void* action, std::size_t k, std::size_t worker),
                           const void* action) {
  LoopOrder order;
  order.begin();
  const bool timed = arena_->busy.has_value();
  const auto began = timed ? Clock::now() : Clock::time_point{};
  arena_->execute([&] {
    oneapi::tbb::parallel_for(
        oneapi::tbb::blocked_range<std::size_t>(0, count, 1),
        [&](const auto& range) {
          order.enter();
          const auto worker = static_cast<std::size_t>(oneapi::tbb::this_task_arena::current_thread_index());
          const auto entered = timed ? Clock::now() : Clock::time_point{};
          for (std::size_t k = range.begin(); k != range.end(); ++k) call(action, k, worker);
          if (timed) (*arena_->busy)[worker] += seconds_since(entered);
          order.leave();
        },
        oneapi::tbb::simple_partitioner());
  });
  order.end();
  if (timed) arena_->loops += seconds_since(began);
}

}  // namespace diefill::engine
