// Roots without root and quotient instructions.
#include "engine/numerics/reciprocal_root.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "engine/numerics/vector_instructions.h"

namespace diefill::engine {
namespace {

TEST(ReciprocalRoot, IsWithinAFewRoundingsOverTheWholeRange) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> exponent(-300, 300);
  for (int k = 0; k < 100000; ++k) {
    const double x = std::pow(10.0, exponent(random));
    EXPECT_NEAR(reciprocal_root(x) * std::sqrt(x), 1, 4e-16) << x;
  }
  // Over one period of the first guess, which repeats with every factor of 4.
  for (double x = 1; x < 4; x += 1e-5) EXPECT_NEAR(reciprocal_root(x) * std::sqrt(x), 1, 4e-16) << x;
}

TEST(ReciprocalRoot, MakesTheRootOfZeroZero) {
  EXPECT_GT(reciprocal_root(0), 1e150);
  EXPECT_EQ(0 * reciprocal_root(0), 0);
}

TEST(ReciprocalRoot, HasTheSameBitsWithAllInstructions) {
  constexpr int kCount = 1000;
  double plain[kCount], best[kCount];
  const auto roots = [](double* root) {
    for (int k = 0; k < kCount; ++k) root[k] = reciprocal_root(1e-9 * (k + 1));
  };
  with_instructions(InstructionSet::baseline, [&] { roots(plain); });
  with_instructions(best_instruction_set(), [&] { roots(best); });
  for (int k = 0; k < kCount; ++k) EXPECT_EQ(plain[k], best[k]);
}

}  // namespace
}  // namespace diefill::engine
