#include "tests/app/small_die.h"

#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace diefill::app {

namespace {

// Coarse, soft grains and coarse walls: quick, and still a filling.
const char* const kScene = R"(title = "Small die, one passage"
seed = 1

[powder]
preset = "ASC100.29 A2"
grain_diameter = "1 mm"
reduced_modulus = "3 MPa"
damping_over_radius = "3e5 Pa s/m"

[walls]
sphere_radius = "0.25 mm"

[[tool]]
name = "die"
role = "die"
file = "die.stl"
length_unit = "mm"

[[tool]]
name = "shoe"
role = "shoe"
file = "shoe.stl"
length_unit = "mm"
position = ["3 mm", "0 mm", "0 mm"]

[pour]
from = ["0.5 mm", "-2.5 mm", "0 mm"]
to = ["5.5 mm", "2.5 mm", "9 mm"]
fill_height = "5 mm"

[[step]]
kind = "passage"
tool = "shoe"
direction = "-x"
velocity = "0.1 m/s"

[numerics]
time_step_fraction = 0.15
checkpoint_interval = "1 s"
)";

}  // namespace

cad::Part small_die() {
  return cad::block_with_pocket(cad::rectangle(-15, 6, -3.5, 3.5), cad::rectangle(-5, -1, -2, 2), -5, -4, 0);
}

cad::Part small_shoe() {
  return cad::tube(cad::rectangle(-3.1, 3.1, -3.1, 3.1), cad::rectangle(-2.5, 2.5, -2.5, 2.5), 0, 10);
}

std::string contents(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw std::runtime_error("cannot read " + file.string());
  std::ostringstream bytes;
  bytes << stream.rdbuf();
  return bytes.str();
}

SmallDie::SmallDie() {
  std::string pattern = (std::filesystem::temp_directory_path() / "diefill_small_die_XXXXXX").string();
  if (mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("no folder for the test could be made");
  folder_ = pattern;
  write("die.stl", cad::binary_stl(small_die()));
  write("shoe.stl", cad::binary_stl(small_shoe()));
  write("scene.toml", kScene);
}

SmallDie::~SmallDie() {
  std::error_code ignored;
  std::filesystem::remove_all(folder_, ignored);
}

void SmallDie::write(const std::string& name, const std::string& bytes) const {
  std::ofstream(folder_ / name, std::ios::binary) << bytes;
}

void SmallDie::exchange(const std::string& old, const std::string& text) const {
  std::string scene_text = contents(scene());
  const std::size_t place = scene_text.find(old);
  if (place == std::string::npos) throw std::logic_error("the scene has no \"" + old + "\"");
  write("scene.toml", scene_text.replace(place, old.size(), text));
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
