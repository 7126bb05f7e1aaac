// What is kept of sums and of contacts between the passes of a step.
#include <gtest/gtest.h>

#include "engine/search/pair_table.h"

namespace diefill::engine {
namespace {

ContactSum some_sum(double start) {
  ContactSum sum;
  sum.add_force({start, start + 1, start + 2});
  sum.add_moment({start + 3, start + 4, start + 5});
  sum.add_rolling_load(start + 6);
  return sum;
}

/// Force, moment and rolling load.
std::vector<double> numbers_of(const ContactSum& sum) {
  const Vector3 force = sum.force(), moment = sum.moment();
  return {force.x, force.y, force.z, moment.x, moment.y, moment.z, sum.rolling_load()};
}

/// The same of a sum that is kept.
std::vector<double> numbers_of(const ContactSums& sums, std::size_t k) {
  const Vector3 force = sums.force(k), moment = sums.moment(k);
  return {force.x, force.y, force.z, moment.x, moment.y, moment.z, sums.rolling_load(k)};
}

TEST(ContactSums, KeepTheNumbersThatCountAndNoOthers) {
  const std::vector<ContactSum> given = {some_sum(1), some_sum(20), some_sum(40)};
  for (const std::size_t numbers : {ContactSum::kForce, ContactSum::kMoment, ContactSum::kRolling}) {
    ContactSums kept;
    kept.start(given.size(), numbers);
    std::vector<ContactSum> taken = given;
    kept.keep(taken);
    for (const ContactSum& sum : taken) EXPECT_EQ(numbers_of(sum), std::vector<double>(7, 0.0));
    EXPECT_EQ(kept.bytes(), given.size() * numbers * sizeof(double));
    ContactSums first;
    first.copy_first(kept, 2);
    EXPECT_EQ(first.size(), 2U);
    for (std::size_t k = 0; k < given.size(); ++k) {
      std::vector<double> expected = numbers_of(given[k]);
      std::fill(expected.begin() + static_cast<std::ptrdiff_t>(numbers), expected.end(), 0.0);
      EXPECT_EQ(numbers_of(kept, k), expected);
      if (k < first.size()) {
        EXPECT_EQ(numbers_of(first, k), expected);
      }
    }
  }
}

TEST(ContactSums, AddToOneSumWithoutTouchingItsNeighbours) {
  for (const std::size_t numbers : {ContactSum::kForce, ContactSum::kMoment, ContactSum::kRolling}) {
    std::vector<ContactSum> given = {some_sum(1), some_sum(20), some_sum(40)};
    ContactSums kept;
    kept.start(given.size(), numbers);
    kept.keep(given);
    const std::vector<double> first = numbers_of(kept, 0), last = numbers_of(kept, 2);
    std::vector<double> expected = numbers_of(kept, 1);
    for (std::size_t k = 0; k < numbers; ++k) expected[k] += static_cast<double>(k + 1);
    kept.add_force(1, {1, 2, 3});
    kept.add_moment(1, {4, 5, 6});
    kept.add_rolling_load(1, 7);
    EXPECT_EQ(numbers_of(kept, 0), first);
    EXPECT_EQ(numbers_of(kept, 1), expected);
    EXPECT_EQ(numbers_of(kept, 2), last);
  }
}

TEST(GrainPairTable, KeepsHistoriesOfTouchingPairsOnlyInTheirOrder) {
  const double one[] = {1, 2, 3}, other[] = {4, 5, 6}, opposite[] = {-1, -1, -1};
  GrainPairTable table;
  table.start(3, 3);
  table.add({0, 1}, one, nullptr);
  table.add({0, 2}, nullptr, nullptr);
  table.add({1, 2}, other, opposite);
  table.finish();
  EXPECT_EQ(table.history.size(), 3U * 3U + GrainPairTable::kSpare);
  std::vector<std::pair<std::size_t, double>> seen;
  table.visit_touching([&](std::size_t p, const double* history) { seen.emplace_back(p, history[2]); });
  EXPECT_EQ(seen, (std::vector<std::pair<std::size_t, double>>{{0, 3.0}, {2, -6.0}}));
  EXPECT_EQ(table.history_at(GrainPairTable::kNothing)[0], 0);
}

TEST(GrainPairTable, TakesOverTheHistoriesOfAStep) {
  const double one[] = {1, 2, 3};
  GrainPairTable table;
  table.start(3, 3);
  table.add({0, 1}, one, nullptr);
  table.add({0, 2}, nullptr, nullptr);
  table.add({1, 2}, nullptr, nullptr);
  table.finish();
  std::vector<double> next(1, 99.0);
  table.make_room_for_history(next, 2);
  ASSERT_EQ(next.size(), (2 + 1) * 3 + GrainPairTable::kSpare);
  for (std::size_t k = 0; k < 6; ++k) next[3 + k] = 7.0 + static_cast<double>(k);
  table.touching = {0, 1, 1};
  table.keep_history(next);
  EXPECT_EQ(table.history_at(GrainPairTable::kNothing)[0], 0);
  EXPECT_EQ(table.history_at(1)[0], 7.0);
  EXPECT_EQ(table.history_at(2)[2], 12.0);
  EXPECT_EQ(table.history.size(), 3U * 3U + GrainPairTable::kSpare);
}

}  // namespace
}  // namespace diefill::engine
