// Sample scenes with a few words exchanged, and what estimates say of them.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "process/estimate/estimate.h"
#include "process/setup/read_tooling.h"
#include "project_paths.h"
#include "tests/support/scene_text.h"

namespace diefill::process::estimate {

/// Pairs of what stands in a scene file and what is to stand there instead.
using Exchanges = std::vector<std::pair<std::string, std::string>>;

/// The scene sample_tools/`name` with all that `exchanges` say.
inline Scene sample(const std::string& name, const Exchanges& exchanges = {}) {
  const Scene scene = read_scene(std::string(DIEFILL_SOURCE_DIR) + "/sample_tools/" + name);
  std::string text = scene.text;
  for (const auto& [old, replacement] : exchanges) text = support::exchanged(text, old, replacement);
  return exchanges.empty() ? scene : parse_scene(text, scene.file);
}

/// Its estimate.
inline Estimate estimated(const std::string& name, const Exchanges& exchanges = {},
                          const EstimateOptions& options = {}) {
  const Scene scene = sample(name, exchanges);
  return estimate(scene, read_tooling(scene), options);
}

/// All that an estimate says, and what it says first.
inline std::string all_said(const Estimate& found) {
  std::string text;
  for (const Statement& statement : statements(found))
    text += statement.topic + ": " + statement.words + '\n';
  return text;
}
inline std::string answer_said(const Estimate& found) {
  return statements(found).front().words;
}
inline bool says(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// The passage of sample_tools/small_dies/square.toml, to be exchanged for other steps.
inline constexpr const char* kPassageOfSquare = R"([[step]]
kind = "passage"
tool = "shoe"
direction = "-x"
velocity = "0.2 m/s"
passages = 1
acceleration = "10 m/s^2"
clearance = "2 mm"
)";

}  // namespace diefill::process::estimate
