// report.json: names, integers, and numbers that do not exist.
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "process/results/storage/result_file.h"
#include "tests/process/results_sample.h"
#include "tests/support/temporary_folder.h"

namespace diefill::results {
namespace {

using Json = nlohmann::ordered_json;

Json report_of(const FillResult& result) {
  const support::TemporaryFolder scratch;
  write_report(scratch.path(), result);
  std::ifstream stream(scratch.path() / "report.json");
  return Json::parse(stream);
}

TEST(Report, HasTheAgreedKeys) {
  const Json report = report_of(sample_result());
  std::vector<std::string> keys;
  for (const auto& [key, value] : report.items()) keys.push_back(key);
  const std::vector<std::string> agreed = {"title",
                                           "strategy",
                                           "powder",
                                           "filled_mass_kg",
                                           "solid_fraction",
                                           "grains",
                                           "spheres",
                                           "wall_spheres",
                                           "steps",
                                           "time_step_s",
                                           "simulated_s",
                                           "wall_seconds",
                                           "sphere_steps_per_second",
                                           "energy_balance_error",
                                           "state_hash",
                                           "seed",
                                           "program_version",
                                           "warnings",
                                           "phase_seconds",
                                           "narrowest_mm",
                                           "undefined",
                                           "fill_level"};
  EXPECT_EQ(keys, agreed);
  std::vector<std::string> parts;
  for (const auto& [key, value] : report["solid_fraction"].items()) parts.push_back(key);
  EXPECT_EQ(parts,
            (std::vector<std::string>{"mean", "arithmetic_mean", "std", "min", "max", "cv", "grains"}));
}

TEST(Report, KeepsWholeNumbersWholeAndOthersExact) {
  const Json report = report_of(sample_result());
  for (const char* name : {"grains", "spheres", "wall_spheres", "steps"})
    EXPECT_TRUE(report[name].is_number_integer());
  EXPECT_EQ(report["steps"].get<std::int64_t>(), 123456789);
  EXPECT_EQ(report["seed"].get<std::uint64_t>(), std::numeric_limits<std::uint64_t>::max() - 1);
  EXPECT_EQ(report["solid_fraction"]["grains"].get<std::uint64_t>(), 1234567890123ULL);
  EXPECT_TRUE(report["wall_seconds"].is_number_float());
  EXPECT_EQ(report["filled_mass_kg"].get<double>(), 1.0 / 3000.0);
  EXPECT_EQ(report["phase_seconds"]["contact"].get<double>(), 20);
  EXPECT_EQ(report["title"].get<std::string>(), sample_result().title);
}

TEST(Report, WritesNullForWhatIsNoNumber) {
  FillResult result = sample_result();
  result.summary.mean = std::nan("");
  result.figures["wall_seconds"] = std::numeric_limits<double>::infinity();
  result.figures.erase("energy_balance_error");
  const Json report = report_of(result);
  EXPECT_TRUE(report["undefined"].is_null());
  EXPECT_TRUE(report["solid_fraction"]["mean"].is_null());
  EXPECT_TRUE(report["wall_seconds"].is_null());
  EXPECT_TRUE(report["energy_balance_error"].is_null());
}

TEST(Report, CountsForItselfWhatTheFiguresLeaveOut) {
  FillResult result = sample_result(5);
  result.figures.clear();
  const Json report = report_of(result);
  EXPECT_EQ(report["grains"].get<int>(), 5);
  EXPECT_EQ(report["spheres"].get<int>(), 15);
  EXPECT_EQ(report["wall_spheres"].get<int>(), 6);
  EXPECT_EQ(report["simulated_s"].get<double>(), result.powder.time);
}

TEST(Report, HasTheFillLevel) {
  const Json level = report_of(sample_result())["fill_level"];
  EXPECT_EQ(level["unit"], "mm");
  EXPECT_EQ(level["x_unit"], "deg");
  EXPECT_EQ(level["x"].get<std::vector<double>>(), (std::vector<double>{45, 135, 225, 315}));
  EXPECT_EQ(level["y"][2].get<double>(), 13.25);
  EXPECT_TRUE(level["y"][1].is_null());
}

TEST(Report, SurvivesBytesThatAreNoText) {
  FillResult result = sample_result();
  result.title = "M\xfcller";  // Latin-1
  EXPECT_EQ(report_of(result)["title"].get<std::string>(), "M\xef\xbf\xbdller");
}

}  // namespace
}  // namespace diefill::results
