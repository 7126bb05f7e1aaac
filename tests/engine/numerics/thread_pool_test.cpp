// Who of a thread pool does what.
#include "engine/numerics/thread_pool.h"

#include <gtest/gtest.h>

#include <atomic>
#include <vector>

#include "engine/numerics/per_worker.h"

namespace diefill::engine {
namespace {

TEST(ThreadPool, NoTwoThreadsAreTheSameWorkerAtOnce) {
  constexpr int kThreads = 4;
  constexpr std::size_t kCount = 20000;
  ThreadPool pool(kThreads);
  std::vector<std::atomic<int>> at_work(kThreads), done(kCount);
  std::atomic<int> shared{0}, beyond{0};
  pool.for_each_by_worker(kCount, [&](std::size_t k, std::size_t worker) {
    if (worker >= kThreads) {
      ++beyond;
      return;
    }
    shared += at_work[worker]++ != 0;
    ++done[k];
    --at_work[worker];
  });
  EXPECT_EQ(beyond, 0);
  EXPECT_EQ(shared, 0);
  for (std::size_t k = 0; k < kCount; ++k) ASSERT_EQ(done[k], 1) << k;
}

TEST(ThreadPool, OneThreadIsWorkerZero) {
  ThreadPool pool(1);
  std::size_t sum = 0;
  pool.for_each_by_worker(10, [&](std::size_t k, std::size_t worker) { sum += k + 100 * worker; });
  EXPECT_EQ(sum, 45U);
}

TEST(PerWorker, ValuesShareNoCacheLine) {
  PerWorker<char> values(3);
  const auto apart = [&](std::size_t a, std::size_t b) { return &values[b] - &values[a]; };
  EXPECT_GE(apart(0, 1), 64);
  EXPECT_GE(apart(1, 2), 64);
  EXPECT_EQ(reinterpret_cast<std::uintptr_t>(&values[0]) % 64, 0U);
}

}  // namespace
}  // namespace diefill::engine
