// What the check with finer grains says of a measurement.
#include <gtest/gtest.h>

#include "process/calibration/calibration_results.h"
#include "process/results/none.h"

namespace diefill::process::calibration {
namespace {

/// A measurement of 10 +- 0.1 g.
results::CalibratedMeasurement slit(double simulated, double finer) {
  results::CalibratedMeasurement row;
  row.name = "slit";
  row.unit = "g";
  row.data = {{kNone, kNone, 10, 0.1, simulated, 0.05, 0.05, 9.9, 10.3, finer}};
  return row;
}

TEST(FinerVerdict, SaysWhetherGrainSizeMakesADifference) {
  EXPECT_EQ(finer_verdict(slit(10.1, 10.15), "0.9 mm", 2),
            "with finer grains (0.9 mm) \"slit\" is 10.15 g instead of 10.1 g, measured 10 +- 0.1 g: grain "
            "size makes no difference beyond deviation and scatter");
  EXPECT_EQ(finer_verdict(slit(10.1, 11), "0.9 mm", 2),
            "with finer grains (0.9 mm) \"slit\" is 11 g instead of 10.1 g, measured 10 +- 0.1 g: grain size "
            "matters; use the powder with the grains that it was fitted with");
}

TEST(FinerVerdict, OfSeveralValuesNamesThoseThatDifferMost) {
  auto row = slit(10.1, 10.15);
  row.data.push_back(slit(10.2, 11).data.front());
  const std::string said = finer_verdict(row, "0.9 mm", 1);
  EXPECT_NE(said.find("is 11 g instead of 10.2 g where 2 values differ most, measured 10"), std::string::npos)
      << said;
}

TEST(FinerVerdict, WithoutAValueSaysSo) {
  EXPECT_EQ(finer_verdict(slit(10.1, kNone), "0.9 mm", 2),
            "with finer grains (0.9 mm) \"slit\" has no value: this check says nothing of it");
}

}  // namespace
}  // namespace diefill::process::calibration
