// A parameter: a setting of a scene that trades speed for accuracy. What it changes, which of its values are
// finer, which are worth trying.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "process/input/units.h"
#include "process/scene/variants.h"

namespace diefill::process {

/// Which values of a parameter are more accurate.
enum class Finer { smaller, larger, as_listed, neither };

struct Parameter {
  std::string name;   ///< as --vary takes it, such as "grain_diameter", or the path of a key
  std::string label;  ///< for people, such as "grain diameter d"
  std::string sign;   ///< as short as a chart needs it, such as "d"
  Finer finer = Finer::neither;
  std::optional<Dimension> dimension = {};  ///< of its values; nothing: numbers or words
  std::vector<std::string> words = {};      ///< coarsest first, with Finer::as_listed
  /// The value that the scene has, as --vary would take it.
  std::function<std::string(const Scene&)> current = {};
  /// Values worth trying beside the scene's own; none where the parameter does nothing in this scene.
  std::function<std::vector<std::string>(const Scene&)> usual = {};
  /// What a value changes. Throws SceneError where the scene has nothing that it could change.
  std::function<SceneChanges(const Scene&, const std::string& value)> changes = {};
};

/// The value as a number in SI units; nothing for words and for quantities that cannot be read.
std::optional<double> number_of(const Parameter& parameter, const std::string& value);

/// Whether two values are the same, "1.88 mm" and "0.00188 m" included.
bool same_value(const Parameter& parameter, const std::string& a, const std::string& b);

/// -1 where `a` is coarser than `b`, 1 where it is finer, 0 where the parameter has no order or they are the
/// same.
int fineness(const Parameter& parameter, const std::string& a, const std::string& b);

/// `metres` as --vary takes it, such as "1.88 mm".
std::string in_millimetres(double metres);

/// A value as TOML has it: numbers, true, false and lists as they are, all else in quotes.
std::string toml_value(const std::string& value);

/// A parameter that sets one key to its value.
std::function<SceneChanges(const Scene&, const std::string&)> sets_key(const std::string& key);

}  // namespace diefill::process
