// Published values that settings are compared with: --target of diefill tradeoff.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "process/scene/scene.h"

namespace diefill::app {

/// The values by key of the quantity, in its unit, of words "NAME=NUMBER" or "NAME=NUMBER UNIT". Names that
/// the scene does not have are left for plan_tradeoff() to refuse. Throws process::SceneError, in one line,
/// for other words, a unit that does not fit, a name given twice, a value that the quantity cannot have, and
/// 0 where errors are fractions of the value.
std::map<std::string, double> read_targets(const std::vector<std::string>& words,
                                           const process::Scene& scene);

}  // namespace diefill::app
