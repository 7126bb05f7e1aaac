// Calibration by experiments of the laboratory, and what is refused before anything runs.
#include <gtest/gtest.h>

#include <fstream>

#include "tests/app/small_die.h"
#include "tests/support/scene_text.h"

namespace diefill::app {
namespace {

/// `measurement` is a quantity of an experiment of the laboratory with little powder, and a value for it.
std::string experiment_file(const std::string& measurement) {
  return "powder = \"scene.toml\"\n[[parameter]]\nkey = \"powder.friction\"\nfrom = 0.05\nto = 0.4\n\n"
         "[[measurement]]\nname = \"settled powder\"\nkind = \"experiment\"\n" +
         measurement +
         "\nset = [\"pour.fill_height = '11 mm'\", \"step.passage.travel = '28 mm'\"]\n\n[search]\nseeds = "
         "1\nstart_points = 3\nmost_points = 3\n";
}

TEST(Calibrate, AnExperimentOfTheLaboratoryFindsAPlantedFriction) {
  const SmallDie die;
  const auto calibrate = [&](const std::string& value, std::vector<std::string> more) {
    die.write("calibration.toml",
              experiment_file("experiment = \"mean_fractions\"\nquantity = \"settled\"\nvalue = \"" + value +
                              "\"\ndeviation = \"0.003\""));
    more.insert(more.begin(), {"calibrate", (die.folder() / "calibration.toml").string(), "--out",
                               die.out().string(), "--quiet"});
    return run_program(more);
  };
  // A first run, to have its scene; then that scene with another friction and seed.
  EXPECT_EQ(calibrate("0.5", {"--budget", "0.0001"}).exit_code, 1);
  std::string scene = contents(die.out() / "p001_r01/seed-1/scene.toml");
  const std::size_t friction = scene.find("friction = ", scene.find("[powder]")),
                    end = scene.find('\n', friction);
  scene.replace(friction, end - friction, "friction = 0.15");
  const auto planted = die.out() / "p001_r01/seed-1/planted.toml";
  std::ofstream(planted) << support::exchanged(scene, "seed = 1\n", "seed = 77\n");
  const auto there = die.folder() / "planted";
  const Outcome run =
      run_program({"run", planted.string(), "--out", there.string(), "--no-pictures", "--quiet"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const double fraction =
      nlohmann::json::parse(contents(there / "snapshots/settled/report.json")).at("bulk_solid_fraction");
  std::filesystem::remove_all(die.out());
  const Outcome outcome = calibrate(std::to_string(fraction), {});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  SCOPED_TRACE(outcome.out);
  const auto account = nlohmann::json::parse(contents(die.out() / "calibration.json"));
  const auto& found = account.at("parameters").at(0);
  EXPECT_LE(found.at("lower_90").get<double>(), 0.15);
  EXPECT_GE(found.at("upper_90").get<double>(), 0.15);
  const auto& settled = account.at("measurements").at(0);
  EXPECT_EQ(settled.at("quantity"), "solid fraction of powder in the shoe, settled");
  EXPECT_NEAR(settled.at("data")[0].at("simulated").get<double>(), fraction, 0.01);
}

TEST(Calibrate, UnknownExperimentsAndQuantitiesEndInOneLine) {
  const SmallDie die;
  const auto refused = [&](const std::string& measurement, const std::string& part) {
    die.write("calibration.toml", experiment_file(measurement + "\nvalue = \"0.5\"\ndeviation = \"0.01\""));
    const Outcome outcome =
        run_program({"calibrate", (die.folder() / "calibration.toml").string(), "--out", die.out().string()});
    EXPECT_EQ(outcome.exit_code, 2) << part;
    EXPECT_EQ(outcome.complaints(), 1U) << outcome.err;
    EXPECT_NE(outcome.err.find(part), std::string::npos) << outcome.err;
  };
  refused("experiment = \"mean_fraction\"", "did you mean \"mean_fractions\"?");
  refused("experiment = \"mean_fractions\"\nquantity = \"setled\"", "did you mean \"settled\"?");
  refused("experiment = \"mean_fractions\"\nquantity = \"angle\"", "there are \"settled\", \"moving\"");
  refused("experiment = \"mean_fractions\"\nquantity = \"settled\"\nsize = \"corse\"",
          "did you mean \"coarse\"?");
  refused("experiment = \"clump_collision\"\nquantity = \"B01\"", "powders of its own");
  for (const char* experiment : {"closed_forms", "hopper_design", "wire_sawing"})
    refused("experiment = \"" + std::string(experiment) + "\"\nquantity = \"V04\"",
            "this experiment runs no scenes");
  refused("experiment = \"angle_of_repose\"\nquantity = \"theta_O\"", "the quantity has \"deg\"");
  EXPECT_FALSE(std::filesystem::exists(die.out()));
}

TEST(Calibrate, BadFilesEndInOneLineBeforeAnythingRuns) {
  const SmallDie die;
  const std::string good =
      "[[parameter]]\nkey = \"powder.friction\"\nfrom = 0.1\nto = 1.0\n\n[[measurement]]\nname = \"m\"\n"
      "scene = \"scene.toml\"\nfigure = \"filled_mass_kg\"\nvalue = \"90 mg\"\ndeviation = \"2 mg\"\n";
  const auto refused = [&](const std::string& old, const std::string& text, const std::string& part) {
    die.write("calibration.toml", old.empty() ? good + text : support::exchanged(good, old, text));
    const Outcome outcome =
        run_program({"calibrate", (die.folder() / "calibration.toml").string(), "--out", die.out().string()});
    EXPECT_EQ(outcome.exit_code, 2) << part;
    EXPECT_EQ(outcome.complaints(), 1U) << outcome.err;
    EXPECT_NE(outcome.err.find(part), std::string::npos) << outcome.err;
  };
  refused("\"90 mg\"", "\"90\"", "does not have the dimension of");
  refused("\"90 mg\"", "\"90 mm\"", "does not have the dimension of");
  refused("\"2 mg\"", "\"0 mg\"", "the standard deviation is 0");
  refused("filled_mass_kg", "filled_mass_kgg", "did you mean \"filled_mass_kg\"?");
  refused("scene.toml", "none.toml", "none.toml");
  refused("powder.friction", "powder.frictoin", "did you mean");
  refused("to = 1.0", "to = 100", "calibration.toml:4:6: parameter.to: powder.friction: found 100");
  refused("name = \"m\"", "name = \"m\"\nuse = \"check\"", "use = \"fit\"");
  refused("name = \"m\"", "name = \"m\"\nkind = \"figur\"", "figure");
  refused("", "\n[serch]\nseeds = 2\n", "search");
  refused("", "\n[[parameter]]\nkey = \"walls.friction\"\nfrom = 0.1\nto = 0.5\n",
          "found 1 measured value to fit 2 parameters");
  // Curves: places out of order, given twice, too few deviations.
  const auto curve = [](const std::string& at, const std::string& deviations) {
    return "over = \"step.1.velocity\"\nat = [" + at + "]\nvalues = [\"90 mg\", \"80 mg\"]\ndeviations = [" +
           deviations + "]";
  };
  const std::string single = "value = \"90 mg\"\ndeviation = \"2 mg\"";
  refused(single, curve("\"0.2 m/s\", \"0.1 m/s\"", "\"2 mg\""), "sort the points in rising order");
  refused(single, curve("\"0.1 m/s\", \"0.1 m/s\"", "\"2 mg\""), "this place is given twice");
  refused(single, curve("\"0.1 m/s\", \"0.2\"", "\"2 mg\""), "0.2");
  refused(single, curve("\"0.1 m/s\", \"0.2 m/s\"", "\"2 mg\", \"2 mg\", \"2 mg\""), "as many entries as");
  EXPECT_FALSE(std::filesystem::exists(die.out()));
}

}  // namespace
}  // namespace diefill::app
