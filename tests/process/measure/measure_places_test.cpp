// Maps and sections show powder wherever it is; cavities of any shape have maps.
#include <gtest/gtest.h>

#include "process/measure/fields/box_map.h"
#include "process/measure/fields/measured_fields.h"
#include "process/measure/fields/motion_field.h"
#include "process/measure/fields/powder_places.h"
#include "process/measure/measure.h"
#include "process/results/places_without_value.h"
#include "process/run/assemble.h"
#include "tests/process/measure_sample.h"
#include "tests/process/plan/plan_sample.h"

namespace diefill::process {
namespace {

const results::SectionPlane kUpright{"", {0, 1e-4, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}};

/// A box of 6 x 6 x 6 mm about the origin, filled by a lattice up to `level` (m above the floor).
results::FillResult filled_box(double level) {
  results::FillResult result;
  std::vector<Eigen::Vector3d> places;
  for (const auto& place : block(12, kDiameter))
    if (place.z() < level - 3e-3) places.push_back(place);
  result.powder = powder_of(places);
  result.solid_fraction = fraction_of(result.powder, [](const auto& place) { return 0.4 + 20 * place.x(); });
  result.cavity.lower_corner.setConstant(-3e-3);
  result.cavity.upper_corner.setConstant(3e-3);
  result.cavity.volume = 216e-9;
  return result;
}

double at(const results::Field2D& field, double first, double second) {
  const auto nearest = [](const std::vector<double>& nodes, double place) {
    const auto above = std::lower_bound(nodes.begin(), nodes.end(), place - 1e-9);
    return static_cast<std::size_t>(std::min(above, nodes.end() - 1) - nodes.begin());
  };
  return field.value.at(nearest(field.second, second) * field.first.size() + nearest(field.first, first));
}

TEST(PowderPlaces, PowderWithOpenCellsIsStillPowder) {
  const results::PowderState powder = powder_of(block(13, kDiameter));  // half edge 3 mm
  auto fraction = fraction_of(powder, [](const auto&) { return 0.4; });
  for (auto& open : fraction.open) open = 1;
  const auto section = plane_section(powder, fraction, {}, kUpright, 5e-4).field;
  EXPECT_TRUE(results::is_unvalued_powder(at(section, 0, 0)));
  EXPECT_TRUE(results::is_unvalued_powder(at(section, -2.5, 2.5)));
  EXPECT_TRUE(std::isnan(at(section, 3.9, 0)));
  EXPECT_FALSE(results::is_unvalued_powder(at(section, 3.9, 0)));
}

TEST(PowderPlaces, SectionsOfOneRunHaveOneOutline) {
  results::FillResult result = filled_box(4.1e-3);
  for (std::size_t k = 0; k < result.powder.position.size(); ++k)
    result.solid_fraction.open[k] = result.powder.position[k].z() > 0;  // as at a free surface
  const auto density = plane_section(result.powder, result.solid_fraction, {}, kUpright, 5e-4).field;
  const auto motion = plane_vectors(velocities(result.powder), result, kUpright, 5e-4).field;
  ASSERT_EQ(density.value.size(), motion.value.size());
  int powder = 0, empty = 0;
  for (std::size_t n = 0; n < density.value.size(); ++n) {
    const bool is_powder = !std::isnan(density.value[n]) || results::is_unvalued_powder(density.value[n]);
    EXPECT_EQ(is_powder, !std::isnan(motion.value[n]));
    ++(is_powder ? powder : empty);
  }
  EXPECT_GT(powder, 400);
  EXPECT_GT(empty, 400);
  // The outline is that of the spheres: half a grain above the topmost centres, at 0.75 mm.
  EXPECT_FALSE(std::isnan(at(motion, 0, 0.9)));
  EXPECT_TRUE(std::isnan(at(motion, 0, 1.25)));
}

TEST(PowderPlaces, ToolsAreKnownAsTools) {
  const results::PowderState powder = powder_of(block(13, kDiameter));
  results::ToolState tool;
  for (int n = 0; n < 8; ++n)
    tool.vertices.emplace_back(n & 1 ? 9e-3 : 1e-3, n & 2 ? 1e-3 : -1e-3, n & 4 ? 1e-3 : -1e-3);
  tool.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  const auto section =
      plane_section(powder, fraction_of(powder, [](const auto&) { return 0.4; }), {tool}, kUpright, 5e-4)
          .field;
  EXPECT_TRUE(results::is_inside_tool(at(section, 2, 0)));
  EXPECT_NEAR(at(section, -2, 0), 0.4, 1e-12);
  EXPECT_NEAR(at(section, 0.8, 0), 0.4, 1e-12);  // powder reaches the tool
}

TEST(SectionPlane, HasTheLaboratorysCoordinatesWhereverItsOriginIs) {
  const auto plane = section_plane("", {7e-3, 1e-4, -5e-3}, {0, 1, 0});
  const results::FillResult result = filled_box(6e-3);
  const auto field = plane_section(result.powder, result.solid_fraction, {}, plane, 5e-4).field;
  EXPECT_EQ(field.second_name, "z");
  EXPECT_NEAR(at(field, 1, 0), 0.42, 1e-2);  // the gradient over x counts from x = 0
  EXPECT_NEAR(field.second.front(), -3.75, 1e-6);
  EXPECT_NEAR(field.first.front(), -3.75, 1e-6);
}

TEST(BoxMap, IsTheMeanOverHeightSeenFromAbove) {
  results::FillResult result = filled_box(6e-3);
  result.solid_fraction = fraction_of(result.powder, [](const auto& place) { return 0.4 + 20 * place.z(); });
  const auto plan = box_map(result, BoxView::kPlan, 5e-4);
  EXPECT_EQ(plan.first_name, "x");
  EXPECT_EQ(plan.second_name, "y");
  EXPECT_NEAR(plan.first.front(), -3, 1e-9);
  EXPECT_NEAR(plan.second.back(), 3, 1e-9);
  for (const double value : plan.value) EXPECT_NEAR(value, 0.4, 2e-3);
  const auto side = box_map(result, BoxView::kSide, 5e-4);
  EXPECT_EQ(side.second_name, "height");
  EXPECT_NEAR(at(side, 0, 4.5), 0.43, 3e-3);
  const auto profile = height_profile(side);
  EXPECT_NEAR(profile.y[profile.y.size() / 4], 0.37, 5e-3);
}

TEST(BoxMap, ShowsTheHoleWherePowderIsMissing) {
  results::FillResult result = filled_box(6e-3);
  std::vector<Eigen::Vector3d> places;
  for (const auto& place : result.powder.position)
    if (place.x() < 0) places.push_back(place);
  result.powder = powder_of(places);
  result.solid_fraction = fraction_of(result.powder, [](const auto&) { return 0.4; });
  const auto plan = box_map(result, BoxView::kPlan, 5e-4);
  EXPECT_NEAR(at(plan, -1, 0), 0.4, 1e-12);
  EXPECT_TRUE(std::isnan(at(plan, 1, 0)));
  EXPECT_FALSE(results::is_unvalued_powder(at(plan, 1, 0)));
}

/// A square core of 2.2 mm in the middle of a box 5.75 mm deep, with powder around it up to half the height.
results::FillResult box_with_core() {
  results::FillResult result = filled_box(3e-3);
  std::vector<Eigen::Vector3d> places;
  for (const auto& place : result.powder.position)
    if (std::max(std::abs(place.x()), std::abs(place.y())) > 1.1e-3) places.push_back(place);
  result.powder = powder_of(places);
  result.solid_fraction = fraction_of(result.powder, [](const auto&) { return 0.4; });
  result.cavity.upper_corner.z() = 2.75e-3;
  const auto core = plan::box_mesh({-1.1e-3, -1.1e-3, -4e-3}, {1.1e-3, 1.1e-3, 2.75e-3});
  results::ToolState tool;
  tool.name = tool.role = "core";
  tool.vertices = core.vertices;
  tool.triangles = core.triangles;
  result.tools = {tool};
  return result;
}

// Nodes are 0.25 mm apart. The highest place looked at is 0.24 mm below the top of the core, where the powder
// does not reach.
TEST(BoxMap, SeenFromAbovePowderReachesToolsThatEndAtTheFillPlane) {
  const auto plan = box_map(box_with_core(), BoxView::kPlan, 5e-4);
  for (const double beside : {-1.25, -1.0, 1.0, 1.25}) {
    EXPECT_NEAR(at(plan, beside, 0), 0.4, 1e-12) << beside;
    EXPECT_NEAR(at(plan, 0, beside), 0.4, 1e-12) << beside;
  }
  for (const double within : {-0.75, 0.0, 0.75})
    EXPECT_TRUE(results::is_inside_tool(at(plan, within, 0))) << within;
}

TEST(FillLevelMap, IsTheHeightOfTheSurface) {
  const auto result = filled_box(4.1e-3);
  const auto map = fill_level_map(result);
  EXPECT_EQ(map.quantity, "fill level");
  for (const double level : map.value) EXPECT_NEAR(level, 4, 1e-9);  // top of the highest spheres
  const auto along = fill_level_along_travel(result);
  EXPECT_EQ(along.x_name, "distance along the shoe's travel");
  for (const double level : along.y) EXPECT_NEAR(level, 4, 1e-9);
  EXPECT_EQ(fill_level_along_travel(map, result.cavity).y, along.y);
}

TEST(Fields, OfACavityThatIsNoRingArePlanMapLevelsAndHeightProfile) {
  results::FillResult result = filled_box(6e-3);
  measure_fields(result, {5e-4, {}}, 36);
  ASSERT_EQ(result.maps.size(), 2U);
  EXPECT_EQ(result.maps[0].second_name, "y");
  EXPECT_EQ(result.maps[1].quantity, "fill level");
  ASSERT_EQ(result.profiles.size(), 2U);
  EXPECT_EQ(result.profiles[0].quantity, "fill level");
  EXPECT_EQ(result.profiles[1].x_name, "height");
}

}  // namespace
}  // namespace diefill::process
