// Numbers of a result that settings are judged by, and powders calibrated with.
#include "process/tradeoff/quantities.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/process/measure_sample.h"

namespace diefill::process {
namespace {

/// A slice of 10 mm with a probe in a slit.
Scene slit() {
  Scene scene;
  scene.numerics.period[1] = 0.01;
  scene.powder.apparent_density = 3000;
  ProbeSpec probe;
  probe.name = "slit";
  probe.quantity = ProbeQuantity::flow;
  scene.probes.push_back(probe);
  return scene;
}

/// 2 g of model powder have passed; what is left has a solid fraction of 0.4.
results::FillResult passed() {
  results::FillResult result;
  result.powder = powder_of(block(4, kDiameter));
  result.figures["bulk_solid_fraction"] = 0.4;
  result.probes.push_back({.name = "slit",
                           .columns = {"time", "mass"},
                           .units = {"s", "kg"},
                           .values = {0, 0, 1, 1e-3, 2, 2e-3}});
  return result;
}

double value_of(const Scene& scene, const results::FillResult& result, const std::string& key,
                std::string* unit = nullptr) {
  for (const MeasuredQuantity& quantity : measured_quantities(scene)) {
    if (quantity.about.key != key) continue;
    if (unit != nullptr) *unit = quantity.about.unit;
    return quantity.value(result);
  }
  return std::numeric_limits<double>::quiet_NaN();
}

TEST(FlowQuantities, TurnModelMassIntoVolumeAtRestAndMassOfTheRealPowder) {
  const auto result = passed();
  const double density = result.powder.mass_of(0) / result.powder.solid_volume_of(0);
  std::string unit;
  EXPECT_NEAR(value_of(slit(), result, "mass_through_slit", &unit), 0.2, 1e-12);  // 2 g over 10 mm
  EXPECT_EQ(unit, "g/mm");
  const double area = 2e-3 / density / 0.4 / 0.01 * 1e6;  // mm^2
  EXPECT_NEAR(value_of(slit(), result, "volume_through_slit", &unit), area, 1e-9 * area);
  EXPECT_EQ(unit, "mm^2");
  EXPECT_NEAR(value_of(slit(), result, "real_mass_through_slit", &unit), 3e-3 * area, 1e-9 * area);
  EXPECT_EQ(unit, "g/mm");
}

TEST(FlowQuantities, AreMissingWithoutPowderLeftOrAnApparentDensity) {
  auto result = passed();
  result.figures.erase("bulk_solid_fraction");
  EXPECT_TRUE(std::isnan(value_of(slit(), result, "volume_through_slit")));
  Scene scene = slit();
  scene.powder.apparent_density = 0;
  EXPECT_TRUE(std::isnan(value_of(scene, passed(), "real_mass_through_slit")));
  EXPECT_FALSE(std::isnan(value_of(scene, passed(), "volume_through_slit")));
}

}  // namespace
}  // namespace diefill::process
