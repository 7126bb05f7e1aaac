// Results directories given twice: they would count as two runs.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace diefill::app {

/// Throws process::SceneError, in one line, where two of `directories` are the same, also by another path or
/// a link. `what` names the argument, such as "DIR".
void require_distinct(const std::string& what, const std::vector<std::filesystem::path>& directories);

}  // namespace diefill::app
