// All parameters that `diefill tradeoff` knows by name. To add one: a file in parameters/ with a function
// that gives it, and a line in parameter_registry.cpp.
#pragma once

#include "process/tradeoff/parameter.h"

namespace diefill::process {

/// In the order in which they are tried. Economies of the engine and every other key of a scene need no
/// entry: their path is their name (key_path_parameter).
const std::vector<Parameter>& parameter_registry();

/// The parameter of that name: a registered one, or the key of the scene at that path where the name has a
/// dot. Throws SceneError, with the nearest name, where there is none.
Parameter parameter_called(const std::string& name);

/// Any key of a scene as a parameter, such as "economy.sleep" or "step.1.velocity". Switches are finer when
/// off.
Parameter key_path_parameter(const std::string& path);

}  // namespace diefill::process
