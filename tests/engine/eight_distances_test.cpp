// Eight pairs tested at once give what one at a time gives.
#include "engine/eight_distances.h"

#include <gtest/gtest.h>

#include <random>

#include "engine/vector_instructions.h"

namespace diefill::engine {
namespace {

TEST(EightDistances, SquaresAreThoseOfOneVectorAtATime) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> number(0, 1e-3);
  double vectors[8][4] = {};
  for (auto& vector : vectors)
    for (int axis = 0; axis < 3; ++axis) vector[axis] = number(random);
  for (const auto set : {InstructionSet::baseline, InstructionSet::avx2, best_instruction_set()}) {
    if (set == InstructionSet::avx2 && best_instruction_set() == InstructionSet::baseline) continue;
    double squares[8];
    with_instructions(set, [&] {
      Eight all;
      squares_of_eight([&](int k, Four& vector) { __builtin_memcpy(&vector, vectors[k], sizeof vector); },
                       all);
      __builtin_memcpy(squares, &all, sizeof all);
    });
    for (int k = 0; k < 8; ++k) {
      const auto* v = vectors[k];
      EXPECT_EQ(squares[k], v[0] * v[0] + v[1] * v[1] + v[2] * v[2]) << k;
    }
  }
}

TEST(EightDistances, BytesAndBitsTellWhichAreLess) {
  for (unsigned expected = 0; expected < 256; ++expected) {
    Eight value;
    for (int k = 0; k < 8; ++k) value[k] = (expected >> k & 1) != 0 ? 0.5 : 1.0;
    std::uint64_t bytes = 0;
    with_instructions(best_instruction_set(), [&] { bytes = bytes_where_less(value, Eight{} + 1.0); });
    for (int k = 0; k < 8; ++k) EXPECT_EQ(bytes >> (8 * k) & 0xff, expected >> k & 1);
    EXPECT_EQ(bits_from_bytes(bytes), expected);
  }
}

}  // namespace
}  // namespace diefill::engine
