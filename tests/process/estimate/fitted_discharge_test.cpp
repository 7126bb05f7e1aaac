// Fits of diefill fit-discharge as laws of an estimate: which serve, and why others do not.
#include <gtest/gtest.h>

#include <cmath>

#include "process/estimate/discharge/inflow.h"
#include "process/estimate/discharge/powder_discharge.h"
#include "process/input/scene_error.h"
#include "tests/support/temporary_folder.h"

namespace diefill::process::estimate {
namespace {

class FittedDischarge : public testing::Test {
 protected:
  PowderDischarge read(const std::string& text) const {
    return read_discharge(folder_.write("fit.json", text));
  }
  /// What is said against the fit, without the file's name.
  std::string complaint(const std::string& text) const {
    const std::string file = folder_.write("fit.json", text).string();
    try {
      read_discharge(file);
    } catch (const SceneError& error) {
      const std::string said = error.what();
      EXPECT_EQ(said.find(file + ": "), 0U) << said;
      EXPECT_EQ(said.find('\n'), std::string::npos) << said;
      return said.substr(file.size() + 2);
    }
    return "none";
  }
  static std::string power_law(double exponent, double longest) {
    return R"({"law": "5.18", "largest_x": )" + std::to_string(longest) +
           R"(, "coefficients": {"C_S": {"value": 0.25}, "n": {"value": )" + std::to_string(exponent) + "}}}";
  }
  static std::string slit(const std::string& more) {
    return R"({"law": "beverloo-slit", "coefficients": {"C": {"value": 1.03})" + more + "}";
  }

 private:
  support::TemporaryFolder folder_;
};

TEST_F(FittedDischarge, OfAPowerOfTheSpeedIsWithinTwoPercentOfItWhereItWasMeasured) {
  for (const double n : {-0.3, 0.0, 0.005, 0.2, 0.5, 1.0}) {
    const PowderDischarge law = read(power_law(n, 2.9));
    EXPECT_NEAR(law.longest, 2.9, 1e-12);
    for (double x = 0; x <= 2.9; x += 0.1) {
      const double share = 0.25 * std::pow(x + 0.2, 1 + n);
      EXPECT_NEAR(discharged_share(law, x), share, 0.02 * share) << n << ' ' << x;
    }
  }
}

TEST_F(FittedDischarge, OfRatesThroughSlitsHasTheirSteadyRateAndThePublishedBeginning) {
  const PowderDischarge law = read(slit("}"));
  EXPECT_NEAR(continuum::rate_share(law.numbers, 20), 1.03, 1e-6);
  EXPECT_NEAR(law.numbers.initial / law.numbers.steady,
              continuum::kSimulatedDischarge.initial / continuum::kSimulatedDischarge.steady, 1e-12);
  EXPECT_NE(law.applies.find("how it begins"), std::string::npos);
}

TEST_F(FittedDischarge, SaysThatItsOpeningsCountAsTheyAre) {
  const std::string numbers = R"(, "coefficients": {"C_B": {"value": 0.1}, "C_I": {"value": 0.2},
    "C_F": {"value": 0.9}, "beta": {"value": 1.1}}})";
  for (const char* none : {"", R"(, "effective_opening_grain_diameter_m": 0)"}) {
    const PowderDischarge law = read(R"({"law": "5.17")" + std::string(none) + numbers);
    EXPECT_NE(law.remark.find("fit them again with --grain-diameter"), std::string::npos) << law.remark;
  }
  const PowderDischarge law =
      read(R"({"law": "5.17", "effective_opening_grain_diameter_m": 0.001)" + numbers);
  EXPECT_EQ(law.remark, "");
  EXPECT_EQ(law.grain_diameter, 0);
  EXPECT_NE(
      complaint(R"({"law": "5.17", "effective_opening_grain_diameter_m": -1)" + numbers).find("0 or more"),
      std::string::npos);
}

TEST_F(FittedDischarge, PassesOnWhatTheFitRemarksOn) {
  const PowderDischarge law = read(slit(
      R"(}, "effective_opening_grain_diameter_m": 0.001, "remarks": ["C = 2e-10: check the units", 3])"));
  EXPECT_NE(law.remark.find("fit.json says: C = 2e-10: check the units"), std::string::npos) << law.remark;
}

TEST_F(FittedDischarge, IsInDoubtWhereTheFitSaysSo) {
  const PowderDischarge sound = read(slit("}"));
  EXPECT_TRUE(sound.doubts.empty());
  EXPECT_TRUE(sound.holds_beyond_longest);
  const PowderDischarge law =
      read(slit(R"(}, "doubts": ["check the units"], "holds_beyond_largest_x": false)"));
  EXPECT_EQ(law.doubts, std::vector<std::string>{"check the units"});
  EXPECT_FALSE(law.holds_beyond_longest);
}

TEST_F(FittedDischarge, GrainsAsItWasMeasuredWithFeelOpeningsAsItSays) {
  const std::string grain = R"(, "effective_opening_grain_diameter_m": 0.001)";
  for (const auto& [more, annulus] : {std::pair{"}" + grain, 1.4},
                                      {R"(, "k": {"value": 1.7}})" + grain, 1.7},
                                      {R"(, "k": {"value": 1.0}})" + grain, 1.0}}) {
    const InflowPowder powder{read(slit(more)), 3000, 0.001};
    EXPECT_NEAR(effective_width(0.01, powder), 0.01 - annulus * 0.001, 1e-12);
  }
}

TEST_F(FittedDischarge, OfAnotherKindIsRefusedWithTheReason) {
  const auto refused = [&](const std::string& text, const std::string& part) {
    const std::string said = complaint(text);
    EXPECT_EQ(said.find("found "), 0U) << said;
    EXPECT_NE(said.find(part), std::string::npos) << said;
  };
  refused(R"({"law": "beverloo-round", "coefficients": {"C": {"value": 0.58}}})", "through holes");
  refused(R"({"law": "5.16", "coefficients": {}})", "allowed: 5.17, 5.18, transient, beverloo-slit");
  refused(power_law(3, 2.9), "no steady rate");
  refused(power_law(0.2, 0), "measure at lower speeds");
  refused(R"({"law": "5.18", "coefficients": {"C_S": {"value": 0.25}, "n": {"value": 0.2}}})",
          "no number largest_x");
  refused(R"({"law": "5.18", "largest_x": 2, "coefficients": {"C_S": {"value": -1}, "n": {"value": 0}}})",
          "C_S = -1, allowed: above 0");
  refused(R"({"law": "beverloo-slit", "coefficients": {}})", "no coefficient C");
  refused(R"({"law": "5.17", "coefficients": {"C_B": {"value": 0.1}, "C_I": {"value": 0.2},
    "C_F": {"value": 0}, "beta": {"value": 1.1}}})",
          "C_F = 0, allowed: above 0");
}

}  // namespace
}  // namespace diefill::process::estimate
