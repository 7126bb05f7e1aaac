// Changes of a scene that a command line gives (--set).
#pragma once

#include <string>
#include <vector>

namespace diefill::process {

/// Throws SceneError for a text without a change: an empty one, a comment, the header of a table without
/// keys.
void refuse_changes_of_nothing(const std::vector<std::string>& changes);

}  // namespace diefill::process
