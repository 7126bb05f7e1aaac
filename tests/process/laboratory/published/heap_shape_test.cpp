// Toe and peak of heaps that are known.
#include "process/laboratory/published/bierwisch/heap_shape.h"

#include <gtest/gtest.h>

#include <cmath>

namespace diefill::process::laboratory {
namespace {

/// Grains of 1 mm under the line from x = 0 to a wall at 40 mm, of slope 1/2, cut off at `highest` (m).
results::PowderState heap(double highest) {
  results::PowderState powder;
  powder.grain_diameter = 1e-3;
  for (int column = 1; column < 40; ++column)
    for (int layer = 0; 2 * layer <= column; ++layer) {
      const double height = std::min(0.5e-3 * layer * 2, highest);
      powder.position.emplace_back(1e-3 * column, 0, height);
    }
  return powder;
}

const Eigen::Vector3d kFrom = {-0.03, -1, 0}, kTo = {0.04, 1, 1};

TEST(HeapShape, AFlatPeakLacksHeight) {
  const HeapShape sharp = heap_shape(heap(1), kFrom, kTo, true),
                  flat = heap_shape(heap(0.016), kFrom, kTo, true);
  EXPECT_LT(std::abs(sharp.peak), 0.5e-3);
  EXPECT_GT(flat.peak, 1e-3);
}

TEST(HeapShape, GrainsThatHaveRunOutAreTheToe) {
  auto powder = heap(1);
  const double before = heap_shape(powder, kFrom, kTo, true).toe;
  EXPECT_LT(before, 1e-3);
  const std::size_t few = powder.position.size() / 20;
  for (std::size_t k = 0; k < few; ++k) powder.position.emplace_back(-0.01, 0, 0);
  EXPECT_GT(heap_shape(powder, kFrom, kTo, true).toe, before + 5e-3);
}

TEST(HeapShape, TurnedAboutItIsTheSame) {
  const HeapShape rising = heap_shape(heap(0.016), kFrom, kTo, true);
  auto turned = heap(0.016);
  for (auto& place : turned.position) place.x() = -place.x();
  const HeapShape falling = heap_shape(turned, {-0.04, -1, 0}, {0.03, 1, 1}, false);
  EXPECT_NEAR(falling.toe, rising.toe, 1e-9);
  EXPECT_NEAR(falling.peak, rising.peak, 1e-9);
}

TEST(SurfaceDrift, IsThatOfTheHighestGrainsAtRest) {
  auto before = heap(1);
  before.velocity.assign(before.position.size(), Eigen::Vector3d::Zero());
  before.time = 2;
  auto after = before;
  after.time = 4;
  for (auto& place : after.position) place.z() -= 0.6e-3;
  const std::vector<Eigen::AlignedBox3d> box = {{Eigen::Vector3d(0, -1, -0.01), Eigen::Vector3d(1, 1, 1)}};
  EXPECT_NEAR(surface_drift(before, after, box), 0.3, 1e-9);
  // Grains that fall over the heap, and such as lie beside it, do not count.
  for (double x = 0.01; x < 0.03; x += 1e-3) {
    after.position.emplace_back(x, 0, 0.03);
    after.velocity.emplace_back(0, 0, -0.5);
  }
  before.position.emplace_back(-0.005, 0, 0);
  before.velocity.emplace_back(0, 0, 0);
  EXPECT_NEAR(surface_drift(before, after, box), 0.3, 1e-9);
  EXPECT_TRUE(std::isnan(surface_drift(before, after, {})));
}

}  // namespace
}  // namespace diefill::process::laboratory
