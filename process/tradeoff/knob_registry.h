// All knobs that `diefill tradeoff` knows by name. To add one: a file in knobs/ with a function that gives
// it, and a line in knob_registry.cpp.
#pragma once

#include "process/tradeoff/knob.h"

namespace diefill::process {

/// In the order in which they are tried. Economies of the engine and every other key of a scene need no
/// entry: their path is their name (key_path_knob).
const std::vector<Knob>& knob_registry();

/// The knob of that name: a registered one, or the key of the scene at that path where the name has a dot.
/// Throws SceneError, with the nearest name, where there is none.
Knob knob_called(const std::string& name);

/// Any key of a scene as a knob, such as "economy.sleep" or "step.1.velocity". Switches are finer when off.
Knob key_path_knob(const std::string& path);

}  // namespace diefill::process
