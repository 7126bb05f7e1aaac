// Records turn into lanes and back, whatever instructions do it.
#include "engine/numerics/transpose.h"

#include <gtest/gtest.h>

#include <vector>

#include "engine/numerics/vector_instructions.h"

namespace diefill::engine {
namespace {

TEST(Transpose, LanesHoldOneNumberOfEachRecordAndComeBack) {
  for (const auto set : {InstructionSet::baseline, best_instruction_set()}) {
    double given[4][4], back[4][4], lanes[4][4] = {};
    for (int r = 0; r < 4; ++r)
      for (int k = 0; k < 4; ++k) given[r][k] = 10 * r + k;
    with_instructions(set, [&] {
      Records records;
      for (int r = 0; r < 4; ++r) load(records.row[r], given[r]);
      records.transpose();
      for (int k = 0; k < 4; ++k) records.to_lanes(static_cast<std::size_t>(k), lanes[k]);
      Records returned{};
      for (int k = 0; k < 3; ++k) returned.from_lanes(static_cast<std::size_t>(k), lanes[k]);
      returned.transpose();
      for (int r = 0; r < 4; ++r) store(returned.row[r], back[r]);
    });
    for (int r = 0; r < 4; ++r)
      for (int k = 0; k < 4; ++k) {
        EXPECT_EQ(lanes[k][r], 10 * r + k);
        EXPECT_EQ(back[r][k], k < 3 ? 10 * r + k : 0);
      }
  }
}

TEST(Transpose, ReadsThreeNumbersAndPutsZeroBehindThem) {
  // Just as many as there are: what lies after is the next grain's.
  const std::vector<double> three = {1, 2, 3};
  Four numbers;
  load_three(numbers, three.data());
  for (int k = 0; k < 4; ++k) EXPECT_EQ(numbers[k], k < 3 ? k + 1 : 0);
}

TEST(Transpose, ReadsAndAddsAtAnyBorderOfANumber) {
  double numbers[6] = {1, 2, 3, 4, 5, 6};
  add_to(numbers + 1, Four{10, -1, 0.5, 0});
  const double expected[6] = {1, 12, 2, 4.5, 5, 6};
  for (int k = 0; k < 6; ++k) EXPECT_EQ(numbers[k], expected[k]);
}

}  // namespace
}  // namespace diefill::engine
