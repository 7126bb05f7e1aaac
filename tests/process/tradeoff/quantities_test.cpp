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

/// A slice of 10 mm with a zone for all of it and one for 4 mm of it.
Scene with_zones(double period) {
  Scene scene;
  scene.numerics.period[1] = period;
  scene.text =
      "[[measure.zone]]\nname = \"upper\"\nheights = [\"0 mm\", \"5 mm\"]\n"
      "[[measure.zone]]\nname = \"strip\"\nfrom = [\"-9 mm\", \"-1 mm\", \"0 mm\"]\n"
      "to = [\"9 mm\", \"3 mm\", \"5 mm\"]\n"
      "[[measure.zone]]\nname = \"hub\"\nouter_radius = \"2 mm\"\n";
  return scene;
}

TEST(ZoneQuantities, MassesOfASliceArePerLengthOfTheZoneInIt) {
  results::FillResult result;
  result.figures["filled_mass_in_upper_kg"] = 2e-3;
  result.figures["filled_mass_in_strip_kg"] = 8e-4;
  result.figures["filled_mass_in_hub_kg"] = 4e-4;
  result.figures["mass_share_in_upper"] = 0.5;
  std::string unit;
  EXPECT_NEAR(value_of(with_zones(0.01), result, "filled_mass_in_upper", &unit), 0.2, 1e-12);
  EXPECT_EQ(unit, "g/mm");
  EXPECT_NEAR(value_of(with_zones(0.01), result, "filled_mass_in_strip"), 0.2, 1e-12);
  EXPECT_NEAR(value_of(with_zones(0.01), result, "filled_mass_in_hub"), 0.1, 1e-12);
  EXPECT_EQ(value_of(with_zones(0.01), result, "mass_share_in_upper", &unit), 50);
  EXPECT_EQ(unit, "%");
  // A slice twice as long holds twice as much of the first zone, and as much of the others.
  result.figures["filled_mass_in_upper_kg"] = 4e-3;
  EXPECT_NEAR(value_of(with_zones(0.02), result, "filled_mass_in_upper"), 0.2, 1e-12);
  EXPECT_NEAR(value_of(with_zones(0.02), result, "filled_mass_in_strip"), 0.2, 1e-12);
  EXPECT_NEAR(value_of(with_zones(0.02), result, "filled_mass_in_hub"), 0.1, 1e-12);
}

TEST(ZoneQuantities, MassesOfAWholePartAreMasses) {
  results::FillResult result;
  result.figures["filled_mass_in_upper_kg"] = 2e-3;
  Scene scene = with_zones(0.01);
  scene.numerics.period[1].reset();
  std::string unit;
  EXPECT_NEAR(value_of(scene, result, "filled_mass_in_upper", &unit), 2, 1e-12);
  EXPECT_EQ(unit, "g");
}

}  // namespace
}  // namespace diefill::process
