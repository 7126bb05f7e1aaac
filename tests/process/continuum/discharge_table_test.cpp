// Tables of measured discharges: units, and one clear line for what is wrong.
#include "process/continuum/discharge_table.h"

#include <gtest/gtest.h>

#include "process/input/scene_error.h"
#include "tests/support/temporary_folder.h"

namespace diefill::process::continuum {
namespace {

constexpr CommonToAll kCommon = {3000.0, 6e-3, 33e-3, 32e-3, {}, {}};
constexpr CommonToAll kCommonOverTime = {3000.0, 6e-3, 33e-3, {}, {}, {}};

class DischargeTable : public testing::Test {
 protected:
  std::filesystem::path file(const std::string& text) const {
    folder_.write("masses.csv", text);
    return folder_.path() / "masses.csv";
  }
  /// What is said of a table for the law of the moving shoe.
  std::string complaint(const std::string& text, const CommonToAll& common = kCommon) const {
    try {
      read_discharge_table(file(text), DischargeLaw::moving_shoe, common);
    } catch (const SceneError& error) {
      return error.what();
    }
    return "none";
  }
  void expect_complaint(const std::string& text, const std::string& part) const {
    const std::string said = complaint(text);
    EXPECT_NE(said.find(part), std::string::npos) << said;
    EXPECT_EQ(said.find('\n'), std::string::npos) << said;
  }

 private:
  support::TemporaryFolder folder_;
};

TEST_F(DischargeTable, HasUnitsInItsHeading) {
  const auto data = read_discharge_table(file("\xEF\xBB\xBF# weighed by hand\r\nspeed cm/s,mass [g],error "
                                              "(mg)\r\n10,24.5,300\r\n\r\n20,8,200\r\n"),
                                         DischargeLaw::moving_shoe, kCommon);
  ASSERT_EQ(data.points.size(), 2U);
  EXPECT_NEAR(data.points[0].speed, 0.1, 1e-12);
  EXPECT_NEAR(data.points[0].value, 0.0245, 1e-12);
  EXPECT_NEAR(data.points[0].error, 3e-4, 1e-12);
  EXPECT_NEAR(data.points[1].width, 6e-3, 1e-12);
  EXPECT_NEAR(data.density, 3000, 1e-9);
}

TEST_F(DischargeTable, IsScaledToOneDensityInAnyOrderOfItsLines) {
  CommonToAll common = kCommon;
  common.density.reset();
  const std::string head = "speed m/s,mass g,density g/cm^3\n";
  const auto one = read_discharge_table(file(head + "0.1,3,3\n0.2,2,2.5\n"), DischargeLaw::power_law, common);
  const auto other =
      read_discharge_table(file(head + "0.2,2,2.5\n0.1,3,3\n"), DischargeLaw::power_law, common);
  EXPECT_EQ(one.density, other.density);
  EXPECT_NEAR(one.points[0].value, 0.0025, 1e-15);
  EXPECT_EQ(one.points[0].value, other.points[1].value);
}

TEST_F(DischargeTable, RefusesColumnsAndOptionsWithoutAnEffect) {
  const auto said = [&](const std::string& text, DischargeLaw law, const CommonToAll& common) -> std::string {
    try {
      read_discharge_table(file(text), law, common);
    } catch (const SceneError& error) {
      return error.what();
    }
    return "none";
  };
  const auto expect = [&](const std::string& found, const std::string& part) {
    EXPECT_NE(found.find(part), std::string::npos) << found;
  };
  expect(said("speed m/s,mass g,rate_error g/s\n0.1,3,1\n", DischargeLaw::power_law, kCommon),
         "found column rate_error, which law 5.18 does not take");
  expect(said("speed m/s,mass g,time s\n0.1,3,1\n", DischargeLaw::moving_shoe, kCommon), "column time");
  expect(said("speed m/s,mass g,width mm\n0.1,24.5,10\n", DischargeLaw::moving_shoe, kCommon), "--width: ");
  CommonToAll density;
  density.density = 3000;
  const std::string holes = "rate g/s,diameter mm\n3,5\n";
  EXPECT_EQ(said(holes, DischargeLaw::beverloo_round, density), "none");
  for (std::optional<double> CommonToAll::*option : {&CommonToAll::width, &CommonToAll::length}) {
    CommonToAll more = density;
    more.*option = 0.01;
    expect(said(holes, DischargeLaw::beverloo_round, more), "law beverloo-round has no ");
  }
  expect(said("rate g/s,width mm\n3,5\n", DischargeLaw::beverloo_round, density), "needs diameter");
  expect(said("time s,mass g\n0,0\n0.1,1\n", DischargeLaw::transient, kCommon), "--shoe-length: ");
  CommonToAll opened = kCommon;
  opened.opened = 0.2;
  expect(said("speed m/s,mass g\n0.1,3\n", DischargeLaw::power_law, opened), "law 5.18 has no times");
}

TEST_F(DischargeTable, ColumnsHaveTheLimitsOfTheOptions) {
  CommonToAll common = kCommon;
  common.density.reset();
  for (const char* density : {"1e300", "25.1"}) {
    const std::string said =
        complaint("speed m/s,mass g,density g/cm^3\n0.1,3," + std::string(density) + "\n", common);
    EXPECT_NE(said.find("allowed: at most 25000 kg/m^3"), std::string::npos) << said;
  }
}

TEST_F(DischargeTable, MayBeAFlowProbesFile) {
  const auto path = file("time s,mass kg,mass rate kg/s\n0,0,0\n0.1,0.001,0.01\n0.2,0.003,0.02\n");
  EXPECT_EQ(law_for_table(path), DischargeLaw::transient);
  CommonToAll common = kCommonOverTime;
  common.opened = 0.1;
  const auto data = read_discharge_table(path, DischargeLaw::transient, common);
  ASSERT_EQ(data.points.size(), 2U);
  EXPECT_NEAR(data.points[1].time, 0.1, 1e-12);
  EXPECT_NEAR(data.points[1].value, 0.002, 1e-12);
}

TEST_F(DischargeTable, LeavesOutWhatWasRecordedAfterUntil) {
  const auto path = file("time s,mass kg\n0,0\n0.1,0.001\n0.2,0.003\n0.3,0.005\n0.4,0.005\n");
  CommonToAll common = kCommonOverTime;
  common.opened = 0.1;
  common.until = 0.3;
  const auto data = read_discharge_table(path, DischargeLaw::transient, common);
  ASSERT_EQ(data.points.size(), 3U);
  EXPECT_NEAR(data.points[2].time, 0.2, 1e-12);
  EXPECT_NEAR(data.points[2].value, 0.004, 1e-12);
}

TEST_F(DischargeTable, RefusesAnUntilThatLeavesNothing) {
  const auto path = file("time s,mass kg\n0.1,0.001\n0.2,0.003\n");
  const auto said = [&](std::optional<double> opened, double until, DischargeLaw law) -> std::string {
    CommonToAll common = law == DischargeLaw::transient ? kCommonOverTime : kCommon;
    common.opened = opened;
    common.until = until;
    try {
      read_discharge_table(law == DischargeLaw::transient ? path : file("speed m/s,mass g\n0.1,3\n"), law,
                           common);
    } catch (const SceneError& error) {
      return error.what();
    }
    return "none";
  };
  EXPECT_EQ(said(0.1, 0.1, DischargeLaw::transient), "--until: found 0.1 s, allowed: after --opened, 0.1 s");
  EXPECT_NE(said({}, 0.05, DischargeLaw::transient).find("has no time up to then"), std::string::npos);
  EXPECT_NE(said(0.11, 0.15, DischargeLaw::transient).find("from then on up to --until"), std::string::npos);
  EXPECT_NE(said({}, 0.2, DischargeLaw::moving_shoe).find("law 5.17 has no times"), std::string::npos);
}

TEST_F(DischargeTable, TellsTheLawByItsColumns) {
  EXPECT_EQ(law_for_table(file("mass g,speed m/s\n")), DischargeLaw::moving_shoe);
  EXPECT_EQ(law_for_table(file("rate g/s,diameter mm\n")), DischargeLaw::beverloo_round);
  EXPECT_EQ(law_for_table(file("rate g/s,width mm\n")), DischargeLaw::beverloo_slit);
  EXPECT_THROW(law_for_table(file("mass g\n")), SceneError);
}

TEST_F(DischargeTable, SaysWhatIsWrongInOneLineWithItsPlace) {
  expect_complaint("speed m/s,mass g\n0.1,abc\n", "masses.csv:2:5: column mass: found \"abc\"");
  expect_complaint("speed m/s,mass g\n0.1,\n", "masses.csv:2:5: column mass: found nothing");
  expect_complaint("speed m/s,mass g\n0.1\n", "masses.csv:2: found 1 values, expected 2");
  expect_complaint("speed m/s,mass g\n-0.1,3\n", "found -0.1, allowed: above 0");
  expect_complaint("speed m/s,mass g\n0.1,nan\n", "masses.csv:2:5: column mass");
  expect_complaint("speed,mass g\n0.1,3\n", "\"speed\" without a unit");
  expect_complaint("speed g,mass g\n0.1,3\n", "column speed: found unit \"g\"");
  expect_complaint("sped m/s,mass g\n0.1,3\n", "did you mean \"speed\"?");
  expect_complaint("speed m/s,mass g,mass kg\n0.1,3,4\n", "column mass twice");
  expect_complaint("speed m/s,width mm,mass g,diameter mm\n0.1,6,3,6\n", "width or diameter twice");
  expect_complaint("speed m/s\n0.1\n", "law 5.17 needs mass");
  expect_complaint("speed m/s;mass g\n0.1;2,5\n",
                   "masses.csv:2:5: column mass: found \"2,5\", a number with a "
                   "decimal comma; write a decimal point, such as \"2.5\"");
  expect_complaint("speed m/s,mass g\n0,1,2,5\n",
                   "found 4 values, expected 2, one per column; if these are "
                   "decimal commas, write decimal points");
  expect_complaint("speed m/s,mass g\n0.1,1e999\n",
                   "masses.csv:2:5: column mass: found \"1e999\", too large");
  expect_complaint("speed m/s,mass g\n0.1,0\n", "masses.csv:2: found a mass of 0, allowed: above 0");
  expect_complaint("\n", "found no lines");
  EXPECT_NE(complaint("speed m/s,mass g\n0.1,3\n", {}).find("needs width: add a column, or give --width"),
            std::string::npos);
  expect_complaint("speed m/s,m\xE4ss g\n0.1,3\n", "which is not UTF-8; save the table as UTF-8 text");
  EXPECT_THROW(read_discharge_table("/nowhere/masses.csv", DischargeLaw::moving_shoe, kCommon), SceneError);
}

}  // namespace
}  // namespace diefill::process::continuum
