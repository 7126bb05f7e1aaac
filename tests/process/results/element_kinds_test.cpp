// Shapes of finite elements.
#include <gtest/gtest.h>

#include <algorithm>

#include "process/results/solid_mesh.h"

namespace diefill::results {
namespace {

TEST(ElementKinds, StandInTheOrderOfTheirShapesAndNameEveryNodeInAFace) {
  const auto& kinds = element_kinds();
  ASSERT_EQ(kinds.size(), 7U);
  for (std::size_t k = 0; k < kinds.size(); ++k) {
    EXPECT_EQ(static_cast<std::size_t>(kinds[k].shape), k);
    EXPECT_EQ(&kind_of(kinds[k].shape), &kinds[k]);
    for (int node = 0; node < kinds[k].nodes; ++node)
      EXPECT_TRUE(std::ranges::any_of(
          kinds[k].faces, [&](const auto& face) { return std::ranges::find(face, node) != face.end(); }))
          << kinds[k].name << ", node " << node;
  }
}

}  // namespace
}  // namespace diefill::results
