// Near, close and touching pairs of a block: which are which, and where what they remember stands.
#include "engine/grain_pair_table.h"

#include <gtest/gtest.h>

#include <map>

namespace diefill::engine {
namespace {

constexpr std::size_t kNumbers = 3;

/// A table of `count` near pairs {k, k + 1} that remember kNumbers each, of which every pair in `touching`
/// touches and remembers {k, 2 k, 3 k} for its place k.
GrainPairTable table_of(std::size_t count, const std::vector<std::size_t>& touching) {
  GrainPairTable table;
  table.start(count, kNumbers);
  for (std::size_t k = 0; k < count; ++k) {
    const auto x = static_cast<double>(k);
    const double numbers[kNumbers] = {x, 2 * x, 3 * x};
    const bool touches = std::find(touching.begin(), touching.end(), k) != touching.end();
    table.add({static_cast<LocalSphere>(k), static_cast<LocalSphere>(k + 1)}, touches ? numbers : nullptr,
              nullptr);
  }
  table.finish();
  return table;
}

/// Words in which the bits of `pairs` out of `count` are set.
std::vector<std::uint64_t> words_of(std::size_t count, const std::vector<std::size_t>& pairs) {
  std::vector<std::uint64_t> words((count + GrainPairTable::kWord - 1) / GrainPairTable::kWord);
  for (const std::size_t p : pairs)
    words[p / GrainPairTable::kWord] |= std::uint64_t{1} << p % GrainPairTable::kWord;
  return words;
}

/// Own spheres of the close pairs, which are places of pairs in a table_of().
std::vector<std::size_t> close_places(const GrainPairTable& table) {
  std::vector<std::size_t> places;
  for (const GrainPair& pair : table.close()) places.push_back(pair.own);
  return places;
}

/// Last number that every touching pair remembers, by its place.
std::map<std::size_t, double> last_remembered(const GrainPairTable& table) {
  std::map<std::size_t, double> numbers;
  table.visit_touching(
      [&](std::size_t p, const double* memory) { numbers.emplace(p, memory[kNumbers - 1]); });
  return numbers;
}

TEST(GrainPairTable, RemembersTouchingPairsInTheirOrderOnly) {
  const double one[] = {1, 2, 3}, other[] = {4, 5, 6}, opposite[] = {-1, -1, -1};
  GrainPairTable table;
  table.start(3, kNumbers);
  table.add({0, 1}, one, nullptr);
  table.add({0, 2}, nullptr, nullptr);
  table.add({1, 2}, other, opposite);
  table.finish();
  EXPECT_EQ(last_remembered(table), (std::map<std::size_t, double>{{0, 3.0}, {2, -6.0}}));
  EXPECT_EQ(table.memory_at(GrainPairTable::kNothing)[0], 0);
}

TEST(GrainPairTable, KeepsWhatPairsRememberAfterAStep) {
  auto table = table_of(3, {0});
  table.list_close(words_of(3, {0, 1, 2}), 1e-6);
  std::vector<double> remembered(1, 99.0);
  table.make_room_to_remember(remembered, 2);
  ASSERT_GE(remembered.size(), (2 + 1) * kNumbers);
  for (std::size_t k = 0; k < 2 * kNumbers; ++k) remembered[kNumbers + k] = 7.0 + static_cast<double>(k);
  table.set_touching(0, 0b110);
  table.keep(remembered);
  EXPECT_EQ(table.memory_at(GrainPairTable::kNothing)[0], 0);
  EXPECT_EQ(last_remembered(table), (std::map<std::size_t, double>{{1, 9.0}, {2, 12.0}}));
}

TEST(GrainPairTable, ListsNearAndTouchingPairsAsCloseOnes) {
  // More than two words; 70 touches but is not near any more, and 131 begins a word's last bits.
  constexpr std::size_t kCount = 132;
  auto table = table_of(kCount, {3, 64, 70, 131});
  EXPECT_EQ(close_places(table), (std::vector<std::size_t>{3, 64, 70, 131}));
  table.list_close(words_of(kCount, {0, 3, 63, 64, 100, 131}), 1e-6);
  EXPECT_EQ(close_places(table), (std::vector<std::size_t>{0, 3, 63, 64, 70, 100, 131}));
  EXPECT_EQ(table.touching(0), 0b1011010U);
  EXPECT_EQ(last_remembered(table),
            (std::map<std::size_t, double>{{3, 9.0}, {64, 192.0}, {70, 210.0}, {131, 393.0}}));
}

TEST(GrainPairTable, ForgetsPairsThatNeitherTouchNorAreNear) {
  auto table = table_of(100, {10, 80});
  table.list_close(words_of(100, {5, 10, 80, 99}), 1e-6);
  table.set_touching(0, 0b0100);  // 80 alone
  std::vector<double> remembered;
  table.make_room_to_remember(remembered, 1);
  std::fill(remembered.begin() + kNumbers, remembered.end(), 4.0);
  table.keep(remembered);
  table.list_close(words_of(100, {5}), 1e-6);
  EXPECT_EQ(close_places(table), (std::vector<std::size_t>{5, 80}));
  EXPECT_EQ(last_remembered(table), (std::map<std::size_t, double>{{80, 4.0}}));
}

TEST(GrainPairTable, ClosePairsLastUntilTheirMarginIsUsedUp) {
  auto table = table_of(2, {});
  EXPECT_TRUE(table.age(0)) << "a new table has listed no close pairs yet";
  table.list_close(words_of(2, {1}), 1.0);
  EXPECT_FALSE(table.age(0.5));
  EXPECT_FALSE(table.age(0.25));
  EXPECT_TRUE(table.age(0.25));
  table.list_close(words_of(2, {0}), 1.0);
  EXPECT_FALSE(table.age(0.75));
  table.start(2, kNumbers);
  EXPECT_TRUE(table.age(0));
}

TEST(GrainPairTable, TakesBackWhatPairsRememberedWhenARunWasStopped) {
  const auto stopped = table_of(130, {1, 63, 64, 129});
  auto table = table_of(130, {});
  stopped.visit_touching([&](std::size_t p, const double* memory) { table.recall(p, memory); });
  EXPECT_EQ(last_remembered(table), last_remembered(stopped));
  EXPECT_EQ(close_places(table), close_places(stopped));
  EXPECT_TRUE(table.age(0));
}

TEST(GrainPairTable, VisitsNearPairsWithThePlacesOfTheirMemories) {
  auto table = table_of(70, {2, 69});
  table.list_close(words_of(70, {0, 2, 68}), 1e-6);
  std::map<std::size_t, std::uint32_t> places;
  std::size_t visited = 0;
  table.visit_near([&](std::size_t p, std::uint32_t place) {
    EXPECT_EQ(p, visited++);
    if (place != GrainPairTable::kNothing) places.emplace(p, place);
  });
  EXPECT_EQ(visited, 70U);
  EXPECT_EQ(places, (std::map<std::size_t, std::uint32_t>{{2, 1}, {69, 2}}));
}

}  // namespace
}  // namespace diefill::engine
