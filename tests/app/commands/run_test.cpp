// A run from scene to report, as a user sees it.
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "process/results/storage/result_file.h"
#include "tests/app/small_die.h"

namespace diefill::app {
namespace {

/// Value after `key: ` in what `diefill info` prints.
std::string line_of(const std::string& text, const std::string& key) {
  const std::size_t start = text.find(key + ": ");
  if (start == std::string::npos) return {};
  const std::size_t value = start + key.size() + 2;
  return text.substr(value, text.find('\n', value) - value);
}

std::size_t grains_in_pocket(const results::FillResult& result) {
  std::size_t grains = 0;
  for (const auto& place : result.powder.position)
    if (place[0] > -5e-3 && place[0] < -1e-3 && std::abs(place[1]) < 2e-3 && place[2] > -4e-3 && place[2] < 0)
      ++grains;
  return grains;
}

void expect_plausible_report(const nlohmann::json& report) {
  constexpr double kPocket = 64e-9,
                   kDensity = 5397;  // m^3; kg/m^3 of the preset's grain of 0.3 mm and 7.63e-8 kg
  const double mass = report.at("filled_mass_kg").get<double>();
  EXPECT_GT(mass, 0.2 * kPocket * kDensity);
  EXPECT_LT(mass, 0.74 * kPocket * kDensity);
  const auto& fraction = report.at("solid_fraction");
  // Few grains of a pocket four wide lie two diameters deep: no mean is given for them, and it is said why.
  for (const char* name : {"mean", "arithmetic_mean", "std", "min", "max", "cv"})
    EXPECT_TRUE(fraction.at(name).is_null()) << name;
  EXPECT_LT(fraction.at("grains").get<int>(), 20);
  EXPECT_NE(report.at("no_value").at("solid_fraction").get<std::string>().find("20 are needed"),
            std::string::npos);
  const double filled = report.at("cavity_solid_fraction").get<double>();
  EXPECT_NEAR(filled * kPocket * kDensity, mass, 1e-3 * mass);
  EXPECT_LT(std::abs(report.at("energy_balance_error").get<double>()), 0.005);
  const double grains = report.at("grains").get<double>(), steps = report.at("steps").get<double>();
  EXPECT_EQ(report.at("spheres").get<double>(), grains);
  EXPECT_EQ(grains + report.at("grains_left").get<double>() + report.at("grains_sheared").get<double>(),
            138);  // 5 mm x 5 mm x 5 mm at 0.58, 1 mm spheres
  EXPECT_GT(report.at("wall_spheres").get<double>(), 1000);
  EXPECT_NEAR(report.at("simulated_s").get<double>(), steps * report.at("time_step_s").get<double>(), 1e-9);
  EXPECT_GT(report.at("wall_seconds").get<double>(), 0);
  const double rate =
      report.at("sphere_steps_per_second").get<double>() * report.at("wall_seconds").get<double>();
  EXPECT_GE(rate, 0.99 * grains * steps);
  EXPECT_LE(rate, 1.01 * 138 * steps);
}

// A progress bar is for terminals; a file or a pipe gets plain lines.
void expect_plain_lines(const Outcome& outcome, const SmallDie& die) {
  for (const std::string* text : {&outcome.out, &outcome.err}) {
    EXPECT_EQ(text->find('\033'), std::string::npos);
    EXPECT_EQ(text->find('\r'), std::string::npos);
    EXPECT_EQ(text->find("nan"), std::string::npos) << *text;
  }
  EXPECT_NE(outcome.err.find("1 passage at 0.1 m/s"), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.out.find("results in " + die.out().string()), std::string::npos) << outcome.out;
}

TEST(Run, WritesResultsReportAndPicturesAndSaysSo) {
  const SmallDie die;
  const Outcome outcome = die.run();
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const std::vector<std::string> expected = {
      "fill_level.png", "fill_level_map.png", "height_profile.png", "live.html",   "plan_map.png",
      "report.json",    "results.h5",         "results.xdmf",       "section.png", "snapshot.png"};
  EXPECT_EQ(SmallDie::files_in(die.out()), expected);  // no checkpoint, no temporary files
  std::set<std::string> pictures;
  for (const auto& name : expected) {
    if (!name.ends_with(".png")) continue;
    const std::string picture = contents(die.out() / name);
    EXPECT_EQ(picture.substr(0, 8), "\x89PNG\r\n\x1a\n") << name;
    EXPECT_GT(picture.size(), 5000U) << name;
    EXPECT_TRUE(pictures.insert(picture).second) << name << " is another picture again";
  }
  expect_plain_lines(outcome, die);
  const auto report = die.report();
  expect_plausible_report(report);
  EXPECT_EQ(report.at("warnings").dump().find("out below the cavity"), std::string::npos);

  const auto result = results::read_results(die.out());
  EXPECT_NEAR(report.at("filled_mass_kg").get<double>(),
              static_cast<double>(grains_in_pocket(result)) * result.powder.grain_mass, 1e-12);
  EXPECT_EQ(result.scene_text, contents(die.scene()));
  const Outcome info = run_program({"info", die.out().string()});
  EXPECT_EQ(info.exit_code, 0) << info.err;
  EXPECT_EQ(line_of(info.out, "state_hash"), report.at("state_hash").get<std::string>());
  EXPECT_EQ(line_of(info.out, "title"), "Small die, one passage");
}

TEST(Run, GivesTheSameStateWithOneThreadAndTwo) {
  const SmallDie die;
  die.exchange("grain_diameter = \"1 mm\"",
               "grain_diameter = \"0.5 mm\"");  // more grains than one thread takes at a time
  die.exchange("time_step_fraction = 0.15", "time_step_fraction = 0.3");
  die.exchange("velocity = \"0.1 m/s\"", "velocity = \"0.2 m/s\"");
  ASSERT_EQ(die.run({"--quiet", "--no-pictures"}).exit_code, 0);
  const auto one = die.report();
  const auto other = die.folder() / "two threads";
  const Outcome outcome = run_program(
      {"run", die.scene().string(), "--out", other.string(), "--threads", "2", "--quiet", "--no-pictures"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  const auto two = nlohmann::json::parse(contents(other / "report.json"));
  EXPECT_GT(one.at("grains").get<int>(), 1024);
  EXPECT_EQ(two.at("threads").get<int>(), 2);
  for (const char* key : {"state_hash", "filled_mass_kg", "steps", "energy_balance_error", "solid_fraction"})
    EXPECT_EQ(one.at(key), two.at(key)) << key;
}

TEST(Run, FillsARingAndDrawsItAllRound) {
  const SmallDie die;
  const std::array<cad::Outline, 3> outlines = {cad::circle(8, 32), cad::circle(4, 32), cad::circle(2, 32)};
  die.write("die.stl", cad::binary_stl(cad::block_with_groove(outlines, -5, -4, 0)));
  die.write("shoe.stl", cad::binary_stl(cad::tube(cad::circle(5.6, 32), cad::circle(5, 32), 0, 8)));
  die.exchange("[\"3 mm\", \"0 mm\", \"0 mm\"]", "[\"0 mm\", \"0 mm\", \"0 mm\"]");
  die.exchange(
      "from = [\"0.5 mm\", \"-2.5 mm\", \"0 mm\"]\nto = [\"5.5 mm\", \"2.5 mm\", \"9 mm\"]\nfill_height = "
      "\"5 mm\"",
      "from = [\"-3.5 mm\", \"-3.5 mm\", \"0 mm\"]\nto = [\"3.5 mm\", \"3.5 mm\", \"9 mm\"]\nfill_height = "
      "\"4 mm\"");
  die.exchange("kind = \"passage\"\ntool = \"shoe\"\ndirection = \"-x\"\nvelocity = \"0.1 m/s\"",
               "kind = \"settle\"");
  const Outcome outcome = die.run({"--quiet"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto result = results::read_results(die.out());
  EXPECT_TRUE(result.cavity.is_ring);
  ASSERT_EQ(result.maps.size(), 1U);
  EXPECT_EQ(result.maps.front().first_unit, "deg");
  EXPECT_TRUE(std::filesystem::exists(die.out() / "density_map.png"));
  EXPECT_TRUE(std::filesystem::exists(die.out() / "fill_level.png"));
  const auto level = die.report().at("fill_level");
  EXPECT_EQ(level.at("y").size(), 36U);
}

}  // namespace
}  // namespace diefill::app
