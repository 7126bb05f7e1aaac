// Options of `diefill map` that change nothing of the pictures wanted: refused, not ignored.
#pragma once

#include <string>
#include <vector>

namespace diefill::app {

/// What a command line of `diefill map` asks for.
struct WantedPictures {
  std::vector<std::string> kinds;  ///< of --picture; empty: those of a run
  bool measured = false, time_average = false;
};

/// Options that only some kinds of picture use, such as "--from".
std::vector<std::string> options_of_some_kinds();

/// Throws process::SceneError, in one line, for the first of `given` (of options_of_some_kinds()) that no
/// wanted picture uses.
void require_in_use(const std::vector<std::string>& given, const WantedPictures& wanted);

}  // namespace diefill::app
