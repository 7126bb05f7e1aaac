// A disc that a piston presses on a ring of spheres and a rotor turns: the spheres stick to the floor and do
// not rotate, so that the torque is that of friction at their distance from the axis.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <sstream>

#include "tests/app/cad.h"
#include "tests/app/program.h"
#include "tests/support/temporary_folder.h"

namespace diefill::app {
namespace {

using support::contents;

constexpr double kRing = 3, kFriction = 0.2, kForce = 0.1;  // mm; of the disc; N
constexpr int kSpheres = 12;

const std::string kScene = R"(title = "Disc on a ring of spheres"
[powder]
model = "A"
sphere_radius = "0.5 mm"
grain_mass = "1.3e-6 kg"
grain_diameter = "1 mm"
reduced_modulus = "3 MPa"
damping_over_radius = "3e5 Pa s/m"

[walls]
kind = "mesh"

[[tool]]
name = "floor"
role = "plate"
file = "floor.stl"
length_unit = "mm"
friction = 2

[[tool]]
name = "disc"
role = "punch"
file = "disc.stl"
length_unit = "100 um"
position = ["0 mm", "0 mm", "1.01 mm"]
friction = 0.2

[pour]
grains_file = "ring.csv"

[[step]]
name = "press"
kind = "piston"
tool = "disc"
direction = "-z"
force = "0.1 N"
speed_limit = "5 mm/s"
travel = "0.5 mm"
until = { after = "turn" }

[[step]]
name = "turn"
kind = "rotor"
tool = "disc"
speed_limit = "60 rpm"
steady = { over = "3 deg", within = 0.01 }
start = { with = "press", delay = "40 ms" }

[[step]]
kind = "clear"

[[probe]]
name = "disc"
quantity = "load"
tool = "disc"
interval = "0.5 ms"

[numerics]
checkpoint_interval = "60 s"
)";

/// The folder with scene, tools and spheres; gone at the end.
class RingOfSpheres {
 public:
  RingOfSpheres() {
    folder_.write("floor.stl", cad::binary_stl(cad::prism(cad::rectangle(-6, 6, -6, 6), -2, 0)));
    // Drawn in tenths of a millimetre.
    folder_.write("disc.stl", cad::binary_stl(cad::prism(cad::circle(50, 48), 0, 20)));
    std::ostringstream spheres;
    spheres << "x [mm], y [mm], z [mm], radius [mm]\n";
    for (int k = 0; k < kSpheres; ++k) {
      const double angle = 2 * std::numbers::pi * k / kSpheres;
      spheres << kRing * std::cos(angle) << ", " << kRing * std::sin(angle) << ", 0.5, 0.5\n";
    }
    folder_.write("ring.csv", spheres.str());
    write({});
  }

  /// The scene with `numerics` more.
  void write(const std::string& numerics) const { folder_.write("scene.toml", kScene + numerics); }
  Outcome run(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments = {"run",       (folder_.path() / "scene.toml").string(),
                                          "--out",     out().string(),
                                          "--quiet",   "--no-pictures",
                                          "--threads", "1"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_program(arguments);
  }
  std::filesystem::path out() const { return folder_.path() / "out"; }
  std::string probe() const { return contents(out() / "probe_disc.csv"); }

 private:
  support::TemporaryFolder folder_;
};

/// Rows of the probe: time, force, torque and shift.
std::vector<std::vector<double>> rows_of(const RingOfSpheres& ring) {
  std::istringstream text(ring.probe());
  std::vector<std::vector<double>> rows;
  std::string line;
  std::getline(text, line);  // headings
  while (std::getline(text, line)) {
    rows.emplace_back();
    std::istringstream cells(line);
    for (std::string cell; std::getline(cells, cell, ',');) rows.back().push_back(std::stod(cell));
  }
  return rows;
}

TEST(Rotor, HasTheTorqueOfFrictionUnderItsPiston) {
  const RingOfSpheres ring;
  const Outcome outcome = ring.run();
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  double torque = 0, force = 0, most = 0;
  int count = 0;
  for (const auto& row : rows_of(ring)) {
    if (row.at(3) == 0) continue;
    most = std::max(most, row.at(3));
    // The disc slides from well before the second stretch of 3 degrees on.
    if (row.at(6) > -0.9 * kFriction * kForce * 1e-3 * kRing) continue;
    torque -= row.at(6), force += row.at(3), ++count;
  }
  ASSERT_GT(count, 20);
  EXPECT_LE(most, 1.02 * kForce);
  EXPECT_NEAR(torque / force, kFriction * 1e-3 * kRing, 0.01 * kFriction * 1e-3 * kRing);
}

TEST(Rotor, GoesOnBitForBitAfterARestart) {
  const RingOfSpheres ring;
  ASSERT_EQ(ring.run().exit_code, 0);
  const std::string unbroken = ring.probe();
  std::filesystem::remove_all(ring.out());
  // First while it is pressed, then while it turns.
  for (const char* end : {"20 ms", "52 ms"}) {
    ring.write("max_time = \"" + std::string(end) + "\"\n");
    ASSERT_EQ(ring.run({"--resume"}).exit_code, 4);
  }
  ring.write("max_time = \"5 s\"\n");
  const Outcome last = ring.run({"--resume"});
  ASSERT_EQ(last.exit_code, 0) << last.err;
  EXPECT_EQ(ring.probe(), unbroken);
}

}  // namespace
}  // namespace diefill::app
