// Numbers of spheres and of their cells fit the 32 bits that tables of pairs have for them.
#include "engine/search/sphere_cells.h"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

namespace diefill::engine {
namespace {

double count(const CellNumbers& chosen) {
  return chosen.cells.cast<double>().prod();
}

TEST(SphereCells, AreAsLargeAsAskedWhereThereAreFew) {
  const CellNumbers chosen = cells_for({10.5, 4.5, 0}, 1, 1000);
  EXPECT_EQ(chosen.edge, 1);
  EXPECT_EQ(chosen.cells, Eigen::Vector3i(11, 5, 1));
}

TEST(SphereCells, GrowWhereAFewFarGrainsWouldMakeAHugeGrid) {
  const CellNumbers chosen = cells_for({1000, 1000, 1000}, 1, 1000);
  EXPECT_GT(chosen.edge, 1);
  EXPECT_LE(count(chosen), 4096 + 8 * 1000);
  EXPECT_GT(count(chosen), (4096 + 8 * 1000) / 2.0);
}

TEST(SphereCells, AreNoMoreThanTheirNumbersCanName) {
  const CellNumbers chosen = cells_for({1, 1, 1}, 1e-4, 1000000000);
  EXPECT_GT(count(chosen), 1e9);
  EXPECT_LE(count(chosen), std::numeric_limits<int>::max());
  const CellNumbers in_a_row = cells_for({1, 0, 0}, 1e-10, 1000000000);
  EXPECT_EQ(in_a_row.cells[1], 1);
  EXPECT_GT(in_a_row.cells[0], 1000000000);
}

TEST(SphereCount, IsRefusedWhereSpheresCannotBeNumbered) {
  EXPECT_NO_THROW(check_sphere_count(0xfffffffe));
  EXPECT_THROW(check_sphere_count(0xffffffff), std::length_error);
  EXPECT_THROW(check_sphere_count(std::size_t{1} << 32U), std::length_error);
}

}  // namespace
}  // namespace diefill::engine
