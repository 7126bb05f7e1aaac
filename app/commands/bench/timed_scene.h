// Timing a running scene, as in the middle of a passage: tools move, powder flows, and the run monitors
// both and records what the scene requests.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace diefill::app {

/// What is to be timed.
struct TimedScene {
  std::string scene;          ///< file
  std::filesystem::path run;  ///< directory with the checkpoint of a run of this scene; left as it is
  int threads = 1;
  int warm_up = 100;  ///< steps before timing
  int steps = 600;    ///< to be timed
};

/// Goes on with the run and times it, with all that it does between steps: figures as those of a bed, of
/// wall-clock time. Throws process::SceneError where there is no checkpoint, or where the scene ends before.
nlohmann::ordered_json timed(const TimedScene& wanted);

}  // namespace diefill::app
