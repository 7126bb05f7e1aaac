// The law of the starting flow, found in discharges that are known.
#include "process/laboratory/flow/hopper_transient.h"

#include <gtest/gtest.h>

#include <cmath>

#include "process/continuum/discharge.h"
#include "process/laboratory/flow/registry.h"

namespace diefill::process::laboratory {
namespace {

/// What the law itself lets out, every half millisecond.
std::vector<HopperFields> flows(const std::vector<HopperSetup>& setups, double seconds) {
  std::vector<HopperFields> all;
  for (const HopperSetup& setup : setups) {
    const continuum::SlitFlow slit{1, setup.equivalent_slit, 1, setup.gravity};
    HopperFields fields;
    fields.outflow = continuum::steady_rate(continuum::kSimulatedDischarge, slit);
    for (double time = 5e-4; time < seconds; time += 5e-4) {
      fields.time.push_back(time);
      fields.discharged.push_back(continuum::discharged_mass(continuum::kSimulatedDischarge, slit, time));
    }
    all.push_back(fields);
  }
  return all;
}

TEST(HopperTransient, TheLawOfTheStartingFlowComesBack) {
  const auto setups = transient_setups(4);
  const auto fields = flows(setups, 0.3);
  const auto figures = transient_figures(fit_transient(setups, fields), setups, fields);
  ASSERT_EQ(figures.size(), 5U);
  for (std::size_t k = 0; k < figures.size(); ++k)
    EXPECT_EQ(figures[k].id, flow_experiments().at(1).published_figures.at(k));
  EXPECT_NEAR(figures[0].value, 0.05, 1e-3);
  EXPECT_NEAR(figures[1].value, 0.39, 1e-2);
  EXPECT_NEAR(figures[2].value, 0.92, 1e-2);
  EXPECT_NEAR(figures[3].value, 1.4, 0.05);
  EXPECT_NEAR(figures[4].value, 1.61e5,
              0.01e5);  // grains per second through 10 mm (Bierwisch 2009, Eq. 5.13)
}

TEST(HopperTransient, HasNoValuesWhereTheFlowOnlyGrows) {
  const auto setups = transient_setups(4);
  auto fields = flows(setups, 0.3);
  for (std::size_t k = 0; k < fields.size(); ++k)
    for (std::size_t n = 0; n < fields[k].time.size(); ++n) {
      const double width = setups[k].equivalent_slit;
      const double x = fields[k].time[n] * std::sqrt(setups[k].gravity / width);
      fields[k].discharged[n] = 0.1 * x * x * width * width;
    }
  for (const auto& figure : transient_figures(fit_transient(setups, fields), setups, fields))
    EXPECT_EQ(std::isnan(figure.value), figure.id != "E05") << figure.id;
}

TEST(HopperTransient, SlitsOfCoarseGrainsAreWiderAndLevelsStayHigh) {
  for (const HopperSetup& setup : transient_setups(4)) {
    EXPECT_NEAR(setup.slit - setup.equivalent_slit, 1.4 * 0.75 * setup.powder.grain_diameter, 1e-9);
    EXPECT_GT(setup.to, 2 * setup.equivalent_slit);
    EXPECT_GT(setup.from, setup.to);
    EXPECT_GT(setup.fill, setup.from);
  }
}

}  // namespace
}  // namespace diefill::process::laboratory
