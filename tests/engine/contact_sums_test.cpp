// What is kept of sums between the passes of a step.
#include <gtest/gtest.h>

#include "engine/contact_sums.h"

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

}  // namespace
}  // namespace diefill::engine
