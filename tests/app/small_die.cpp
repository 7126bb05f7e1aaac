#include "tests/app/small_die.h"

#include <algorithm>

#include "tests/support/scene_text.h"

namespace diefill::app {

namespace {

/// Coarse, soft grains and coarse walls: quick, and still a filling.
std::string small_scene() {
  support::SceneTables tables;
  tables.top = R"(title = "Small die, one passage"
seed = 1
)";
  tables.powder = R"(preset = "ASC100.29 A2"
grain_diameter = "1 mm"
reduced_modulus = "3 MPa"
damping_over_radius = "3e5 Pa s/m"
)";
  tables.walls = R"(sphere_radius = "0.25 mm"
)";
  tables.shoe = R"(length_unit = "mm"
position = ["3 mm", "0 mm", "0 mm"]
)";
  tables.pour = R"(from = ["0.5 mm", "-2.5 mm", "0 mm"]
to = ["5.5 mm", "2.5 mm", "9 mm"]
fill_height = "5 mm"
)";
  tables.steps = R"([[step]]
kind = "passage"
tool = "shoe"
direction = "-x"
velocity = "0.1 m/s"
)";
  tables.numerics = R"(time_step_fraction = 0.15
checkpoint_interval = "1 s"
)";
  tables.measure.clear();
  return support::scene_text(tables);
}

}  // namespace

cad::Part small_die() {
  return cad::block_with_pocket(cad::rectangle(-15, 6, -3.5, 3.5), cad::rectangle(-5, -1, -2, 2), -5, -4, 0);
}

cad::Part small_shoe() {
  return cad::tube(cad::rectangle(-3.1, 3.1, -3.1, 3.1), cad::rectangle(-2.5, 2.5, -2.5, 2.5), 0, 10);
}

SmallDie::SmallDie() {
  write("die.stl", cad::binary_stl(small_die()));
  write("shoe.stl", cad::binary_stl(small_shoe()));
  write("scene.toml", small_scene());
}

void SmallDie::exchange(const std::string& old, const std::string& text) const {
  write("scene.toml", support::exchanged(contents(scene()), old, text));
}

void SmallDie::add_tool(const std::string& name, const std::string& role, const cad::Part& part,
                        const std::string& position) const {
  write(name + ".stl", cad::binary_stl(part));
  exchange("[pour]", "[[tool]]\nname = \"" + name + "\"\nrole = \"" + role + "\"\nfile = \"" + name +
                         ".stl\"\nlength_unit = \"mm\"\nposition = " + position + "\n\n[pour]");
}

void SmallDie::exchange_passage(const std::string& steps) const {
  exchange("[[step]]\nkind = \"passage\"\ntool = \"shoe\"\ndirection = \"-x\"\nvelocity = \"0.1 m/s\"\n",
           steps);
}

void SmallDie::pour_into_the_pocket() const {
  exchange(
      "from = [\"0.5 mm\", \"-2.5 mm\", \"0 mm\"]\nto = [\"5.5 mm\", \"2.5 mm\", \"9 mm\"]\nfill_height = "
      "\"5 mm\"",
      "from = [\"-4.95 mm\", \"-1.95 mm\", \"-4 mm\"]\nto = [\"-1.05 mm\", \"1.95 mm\", \"2 "
      "mm\"]\nfill_height = \"2.5 mm\"\nlattice_constant = 1.25");
}

std::vector<std::string> SmallDie::run_arguments(const std::vector<std::string>& more) const {
  std::vector<std::string> arguments = {"run", scene().string(), "--out", out().string(), "--threads", "1"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

std::vector<std::string> SmallDie::files_in(const std::filesystem::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace diefill::app
