// The text of a scene: a shoe `shoe.stl` passes over a die `die.stl`. Tests say what is different in theirs.
#pragma once

#include <stdexcept>
#include <string>

namespace diefill::support {

/// Lines of a scene file, table by table. What a test leaves as it is here describes a narrow ring.
struct SceneTables {
  std::string top = R"(title = "Narrow ring, one passage"
seed = 1
)";
  std::string powder = R"(preset = "Distaloy AE"
grain_diameter = "1.88 mm"
)";
  std::string walls = R"(sphere_radius = "0.15 mm"
spacing = 1.6
)";
  /// Of the tool "shoe", besides name, role and file.
  std::string shoe = R"(length_unit = "mm"
position = ["35.4 mm", "0 mm", "0 mm"]
)";
  std::string pour = R"(from = ["19.4 mm", "-14.5 mm", "0 mm"]
to = ["51.4 mm", "14.5 mm", "110 mm"]
fill_height = "24 mm"
)";
  /// With the headings of the steps.
  std::string steps = R"([[step]]
kind = "passage"
tool = "shoe"
velocity = "0.2 m/s"
direction = "-x"
)";
  std::string numerics = R"(max_time = "5 s"
)";
  std::string measure = R"(fill_plane = "0 mm"
)";
};

/// The scene file's text.
inline std::string scene_text(const SceneTables& tables) {
  return tables.top + "\n[powder]\n" + tables.powder + "\n[walls]\n" + tables.walls + R"(
[[tool]]
name = "die"
role = "die"
file = "die.stl"
length_unit = "mm"

[[tool]]
name = "shoe"
role = "shoe"
file = "shoe.stl"
)" + tables.shoe +
         "\n[pour]\n" + tables.pour + "\n" + tables.steps + "\n[numerics]\n" + tables.numerics +
         "\n[measure]\n" + tables.measure;
}

/// `text` with the first `old` in it exchanged for `replacement`; throws std::logic_error if there is none.
inline std::string exchanged(std::string text, const std::string& old, const std::string& replacement) {
  const std::size_t place = text.find(old);
  if (place == std::string::npos) throw std::logic_error("the text has no \"" + old + "\"");
  return text.replace(place, old.size(), replacement);
}

}  // namespace diefill::support
