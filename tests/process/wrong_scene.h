// A scene with one fault and what the user must be told about it, made from a scene without fault.
#pragma once

#include <ostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/support/scene_text.h"

namespace diefill::process {

/// A scene with a fault. To be tried from a file called `scene.toml` in a folder that holds files `die.stl`,
/// `shoe.stl` and `part.step`, `part.sldprt` and a folder `parts`; what the files contain does not matter,
/// the reader stops before.
struct WrongScene {
  std::string name;
  std::string text;
  std::vector<std::string> expected;  ///< all must stand in the message; the first is file:line:column
};

/// How a test names the case when it fails.
inline std::ostream& operator<<(std::ostream& stream, const WrongScene& scene) {
  return stream << scene.name;
}

/// A scene without fault, which every case spoils in one place.
inline std::string faultless_scene() {
  return support::scene_text({});
}

/// The faultless scene from its start to where `end` begins.
inline std::string scene_up_to(const std::string& end) {
  const std::string text = faultless_scene();
  return text.substr(0, text.find(end));
}

/// The faultless scene with `old` exchanged for `spoilt`, in which '@' marks the place that the message must
/// name.
inline WrongScene spoil(const std::string& name, const std::string& old, const std::string& spoilt,
                        std::vector<std::string> expected) {
  std::string text = support::exchanged(faultless_scene(), old, spoilt);
  const std::size_t mark = text.find('@');
  if (mark == std::string::npos) throw std::logic_error(name + ": no place is marked");
  text.erase(mark, 1);
  std::size_t line = 1, column = 1;
  for (std::size_t i = 0; i < mark; ++i) {
    column = text[i] == '\n' ? 1 : column + 1;
    if (text[i] == '\n') ++line;
  }
  expected.insert(expected.begin(),
                  "scene.toml:" + std::to_string(line) + ':' + std::to_string(column) + ": ");
  return {name, text, expected};
}

}  // namespace diefill::process
