// Many pairs tested at once give what one at a time gives.
#include "engine/contact/pair_distances.h"

#include <gtest/gtest.h>

#include <random>

#include "engine/numerics/vector_instructions.h"

namespace diefill::engine {
namespace {

TEST(PairDistances, SquaresAreThoseOfOneVectorAtATime) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> number(0, 1e-3);
  double vectors[4][4] = {};
  for (auto& vector : vectors)
    for (int axis = 0; axis < 3; ++axis) vector[axis] = number(random);
  for (const auto set : {InstructionSet::baseline, InstructionSet::avx2, best_instruction_set()}) {
    if (set == InstructionSet::avx2 && best_instruction_set() == InstructionSet::baseline) continue;
    double squares[4];
    with_instructions(
        set, [&] { squares_of_four([&](int k, Four& vector) { load(vector, vectors[k]); }, squares); });
    for (int k = 0; k < 4; ++k) {
      const auto* v = vectors[k];
      EXPECT_EQ(squares[k], v[0] * v[0] + v[1] * v[1] + v[2] * v[2]) << k;
    }
  }
}

TEST(PairDistances, BitsComeFromBytes) {
  for (unsigned expected = 0; expected < 256; ++expected) {
    std::uint8_t bytes[8];
    for (unsigned k = 0; k < 8; ++k) bytes[k] = expected >> k & 1;
    EXPECT_EQ(bits_from_bytes(bytes), expected);
  }
}

}  // namespace
}  // namespace diefill::engine
