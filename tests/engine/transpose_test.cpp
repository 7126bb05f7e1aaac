// Records turn into lanes and back, whatever instructions do it.
#include "engine/transpose.h"

#include <gtest/gtest.h>

#include "engine/vector_instructions.h"

namespace diefill::engine {
namespace {

TEST(Transpose, LanesHoldOneNumberOfEachRecordAndComeBack) {
  for (const auto set : {InstructionSet::baseline, best_instruction_set()}) {
    Record given[8], back[8];
    double lanes[8][8] = {};
    for (int r = 0; r < 8; ++r)
      for (int k = 0; k < 8; ++k) given[r].value[k] = 10 * r + k;
    with_instructions(set, [&] {
      Records records;
      for (int r = 0; r < 8; ++r) take(records.row[r], given[r]);
      records.transpose();
      for (int k = 0; k < 8; ++k) records.store(static_cast<std::size_t>(k), lanes[k]);
      Records returned{};
      for (int k = 0; k < 6; ++k) returned.load(static_cast<std::size_t>(k), lanes[k]);
      returned.transpose();
      for (int r = 0; r < 8; ++r) returned.store(static_cast<std::size_t>(r), back[r].value);
    });
    for (int r = 0; r < 8; ++r)
      for (int k = 0; k < 8; ++k) {
        EXPECT_EQ(lanes[k][r], 10 * r + k);
        EXPECT_EQ(back[r].value[k], k < 6 ? 10 * r + k : 0);
      }
  }
}

TEST(Transpose, AddsEachNumberWithItsOwnFactor) {
  double sum[8] = {1, 1, 1, 1, 1, 1, 1, 1};
  add_times(sum, Eight{1, 2, 3, 4, 5, 6, 7, 8}, Eight{1, -1, 1, -1, 0, 2, 0.5, -0.5});
  const double expected[8] = {2, -1, 4, -3, 1, 13, 4.5, -3};
  for (int k = 0; k < 8; ++k) EXPECT_EQ(sum[k], expected[k]);
}

}  // namespace
}  // namespace diefill::engine
