// Who of a thread pool does what.
#include "engine/numerics/thread_pool.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <optional>
#include <stdexcept>
#include <thread>
#include <vector>

#include "engine/numerics/loop_shares.h"
#include "engine/numerics/per_worker.h"
#include "engine/numerics/work_range.h"

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

TEST(ThreadPool, ManyLoopsOfAllLengthsDoEachItemOnce) {
  ThreadPool pool(3);
  for (std::size_t loop = 0; loop < 3000; ++loop) {
    const std::size_t count = loop % 50;
    std::vector<std::atomic<int>> done(count);
    pool.for_each(count, [&](std::size_t k) { ++done[k]; });
    for (std::size_t k = 0; k < count; ++k) ASSERT_EQ(done[k], 1) << k << " of loop " << loop;
  }
}

TEST(ThreadPool, WhatAnItemWritesIsThereAfterTheLoop) {
  ThreadPool pool(2);
  std::vector<std::size_t> values(40);
  for (std::size_t loop = 1; loop <= 1000; ++loop) {
    pool.for_each(values.size(), [&](std::size_t k) { values[k] += k; });
    for (std::size_t k = 0; k < values.size(); ++k) ASSERT_EQ(values[k], k * loop);
  }
}

TEST(ThreadPool, ThrowsWhatAnItemThrowsAndGoesOnAfterwards) {
  ThreadPool pool(2);
  const auto fails = [&] {
    pool.for_each(100, [](std::size_t k) {
      if (k == 70) throw std::runtime_error("item 70");
    });
  };
  for (int loop = 0; loop < 100; ++loop) EXPECT_THROW(fails(), std::runtime_error);
  std::atomic<int> done{0};
  pool.for_each(100, [&](std::size_t) { ++done; });
  EXPECT_EQ(done, 100);
}

TEST(ThreadPool, WakesThreadsThatHaveGoneToSleep) {
  ThreadPool pool(2);
  std::atomic<int> done{0};
  for (int loop = 0; loop < 5; ++loop) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    pool.for_each(10, [&](std::size_t) { ++done; });
  }
  EXPECT_EQ(done, 50);
}

/// First item of each worker, and after the last one `count`.
std::vector<std::size_t> borders_of(const LoopShares& shares, std::size_t count) {
  std::vector<std::size_t> borders = {0};
  shares.divide(count, [&](std::size_t, std::size_t begin, std::size_t end) {
    EXPECT_EQ(begin, borders.back());
    borders.push_back(end);
  });
  return borders;
}

TEST(LoopShares, BeginsWithEqualSharesAndFollowsWhatWorkersDid) {
  LoopShares shares(2);
  EXPECT_EQ(borders_of(shares, 10), (std::vector<std::size_t>{0, 5, 10}));
  for (int loop = 0; loop < 200; ++loop) {
    shares.update(0, 7, 10);
    shares.update(1, 3, 10);
  }
  EXPECT_EQ(borders_of(shares, 10), (std::vector<std::size_t>{0, 7, 10}));
  EXPECT_EQ(borders_of(shares, 100), (std::vector<std::size_t>{0, 70, 100}));
}

TEST(LoopShares, AWorkerWithoutItemsLeavesAllToOthers) {
  LoopShares shares(3);
  for (int loop = 0; loop < 500; ++loop)
    shares.update(2, 0, 9), shares.update(1, 9, 9), shares.update(0, 0, 9);
  EXPECT_EQ(borders_of(shares, 9), (std::vector<std::size_t>{0, 0, 9, 9}));
}

TEST(WorkRange, GivesItsItemsFromBothEnds) {
  WorkRange range;
  range.set(3, 6);
  EXPECT_EQ(range.take_first(), 3U);
  EXPECT_EQ(range.take_last(), 5U);
  EXPECT_EQ(range.take_first(), 4U);
  EXPECT_EQ(range.take_first(), std::nullopt);
  EXPECT_EQ(range.take_last(), std::nullopt);
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
