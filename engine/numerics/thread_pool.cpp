#include "engine/numerics/thread_pool.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <utility>

#include "engine/numerics/loop_shares.h"
#include "engine/numerics/per_worker.h"
#include "engine/numerics/seconds_since.h"
#include "engine/numerics/work_range.h"

namespace diefill::engine {

namespace {

using Clock = std::chrono::steady_clock;

/// Waits for a moment without leaving the processor.
void pause() {
#if defined(__x86_64__)
  __builtin_ia32_pause();
#endif
}

/// Returns true as soon as `done` does, false when it has not for some tenths of a millisecond: long enough
/// for the serial parts of a step. Others that want the processor get it after the first microseconds.
template <class Done>
bool awaited(const Done& done) {
  constexpr int kPauses = 1000, kYields = 1000;
  for (int k = 0; k < kPauses; ++k) {
    if (done()) return true;
    pause();
  }
  for (int k = 0; k < kYields; ++k) {
    if (done()) return true;
    std::this_thread::yield();
  }
  return done();
}

}  // namespace

/// The threads, and the loop that they share. A loop is open while its number is odd. A thread that enters
/// first registers and then checks that the loop is still open; the thread that closes it does so first and
/// then waits for those inside. It does not wait for threads that sleep or that have lost their processor to
/// another program.
class ThreadPool::Team {
 public:
  using Call = void (*)(const void* action, std::size_t k, std::size_t worker);

  explicit Team(int threads) : members_(threads) {
    const auto processors = static_cast<int>(std::thread::hardware_concurrency());
    count_ = static_cast<std::size_t>(std::clamp(threads, 1, std::max(1, processors)));
    try {
      for (std::size_t worker = 1; worker < count_; ++worker)
        threads_.emplace_back([this, worker] { serve(worker); });
    } catch (const std::system_error&) {
      count_ = threads_.size() + 1;  // the system gives no more; with fewer, every result is the same
    }
  }

  ~Team() {
    ended_.store(true);
    loop_.fetch_add(2);
    loop_.notify_all();
    for (auto& thread : threads_) thread.join();
  }

  Team(const Team&) = delete;
  Team& operator=(const Team&) = delete;

  /// Calls call(action, k, worker) for k in [0, count).
  void run(std::size_t count, Call call, const void* action) {
    const auto began = timed ? Clock::now() : Clock::time_point{};
    call_ = call;
    action_ = action;
    LoopShares& shares = shares_of(call);
    shares.divide(count, [&](std::size_t worker, std::size_t begin, std::size_t end) {
      members_[worker].range.set(begin, end);
      members_[worker].taken = 0;
    });
    loop_.fetch_add(1);
    loop_.notify_all();
    work(0);
    loop_.fetch_add(1);
    for (std::size_t w = 1; w < count_; ++w)
      while (!awaited([&] { return !members_[w].inside.load(); })) {
      }
    for (std::size_t w = 0; w < count_; ++w) shares.update(w, members_[w].taken, count);
    if (timed) loops += seconds_since(began);
    if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
  }

  double busy(std::size_t worker) { return members_[worker].busy; }
  void forget_times() {
    loops = 0;
    for (std::size_t w = 0; w < count_; ++w) members_[w].busy = 0;
  }

  bool timed = false;
  double loops = 0;  ///< s

 private:
  struct Member {
    WorkRange range;
    std::atomic<bool> inside{false};
    std::size_t taken = 0;  ///< items in this loop
    double busy = 0;        ///< s
  };

  LoopShares& shares_of(Call loop) {
    for (auto& [known, shares] : shares_)
      if (known == loop) return shares;
    return shares_.emplace_back(loop, LoopShares(count_)).second;
  }

  /// What a thread of the team does until the end.
  void serve(std::size_t worker) {
    std::uint32_t last = 0;
    while (!ended_.load()) {
      if (!awaited([&] { return loop_.load() != last; })) loop_.wait(last);
      last = loop_.load();
      if (last % 2 == 0) continue;
      members_[worker].inside.store(true);
      if (loop_.load() == last) work(worker);
      members_[worker].inside.store(false);
    }
  }

  /// Own items from the front on, then those of others from the back.
  void work(std::size_t worker) {
    const auto entered = timed ? Clock::now() : Clock::time_point{};
    try {
      std::size_t taken = 0;
      for (; const auto k = members_[worker].range.take_first(); ++taken) call_(action_, *k, worker);
      for (std::size_t next = 1; next < count_; ++next)
        for (; const auto k = members_[(worker + next) % count_].range.take_last(); ++taken)
          call_(action_, *k, worker);
      members_[worker].taken += taken;
    } catch (...) {
      fail(std::current_exception());
    }
    if (timed) members_[worker].busy += seconds_since(entered);
  }

  /// Keeps the first failure and leaves nothing to do.
  void fail(std::exception_ptr failure) {
    const std::lock_guard lock(failing_);
    if (!failure_) failure_ = std::move(failure);
    for (std::size_t w = 0; w < count_; ++w) members_[w].range.clear();
  }

  std::size_t count_ = 1;  ///< threads that run, with the calling one
  PerWorker<Member> members_;
  std::vector<std::pair<Call, LoopShares>> shares_;
  Call call_ = nullptr;
  const void* action_ = nullptr;
  std::exception_ptr failure_;
  std::mutex failing_;
  std::atomic<bool> ended_{false};
  alignas(128) std::atomic<std::uint32_t> loop_{0};
  std::vector<std::thread> threads_;
};

ThreadPool::ThreadPool(int threads) : threads_(threads), team_(std::make_unique<Team>(threads)) {}
ThreadPool::~ThreadPool() = default;
ThreadPool::ThreadPool(ThreadPool&&) noexcept = default;
ThreadPool& ThreadPool::operator=(ThreadPool&&) noexcept = default;

void ThreadPool::time_loops() {
  team_->forget_times();
  team_->timed = true;
}

LoopTimes ThreadPool::loop_times() const {
  LoopTimes times;
  if (!team_->timed) return times;
  times.loops = team_->loops;
  for (int worker = 0; worker < threads_; ++worker)
    times.busy.push_back(team_->busy(static_cast<std::size_t>(worker)));
  return times;
}

void ThreadPool::share_out(std::size_t count,
                           void (*call)(const void* action, std::size_t k, std::size_t worker),
                           const void* action) {
  team_->run(count, call, action);
}

}  // namespace diefill::engine
