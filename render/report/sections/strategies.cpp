#include "render/report/sections/strategies.h"

#include <algorithm>
#include <set>
#include <sstream>

#include "process/results/trimmed.h"

namespace diefill::render::report {
namespace {

/// The part of a line before a comment; a # within quotes is none.
std::string without_comment(const std::string& line) {
  bool quoted = false;
  for (std::size_t n = 0; n < line.size(); ++n) {
    if (line[n] == '"') quoted = !quoted;
    if (line[n] == '#' && !quoted) return line.substr(0, n);
  }
  return line;
}

constexpr const char* kBlanks = " \t\r";

bool sets(const std::string& line, const std::string& key) {
  return line.starts_with(key) && results::trimmed(line.substr(key.size()), kBlanks).starts_with('=');
}

/// Equal for runs of one strategy.
std::string identity(const Run& run) {
  if (!run.strategy.empty()) return run.strategy;
  const auto& result = run.result;
  std::string text = result.strategy + '\n' + result.powder_name + '\n';
  for (const auto& line : effective_lines(result.scene_text)) text += '\n' + line;
  for (const auto& tool : result.tools) text += '\n' + tool.mesh_hash;
  return text;
}

/// Strategies are called by what is done where that tells them apart, by their directories otherwise.
void give_names(std::vector<Strategy>& strategies) {
  std::set<std::string> words;
  for (const auto& strategy : strategies) words.insert(strategy.first().strategy);
  const bool telling = words.size() == strategies.size() && !words.contains("");
  for (auto& strategy : strategies) {
    const Run& run = *strategy.runs.front();
    strategy.name = !run.strategy.empty() ? run.strategy : telling ? run.result.strategy : run.name;
  }
}

}  // namespace

Scatter Strategy::of(const std::string& figure_name) const {
  std::vector<double> values;
  for (const Run* run : runs) values.push_back(figure(run->result, figure_name));
  return scatter(values);
}

std::vector<Strategy> strategies_of(const std::vector<Run>& runs) {
  std::vector<Strategy> strategies;
  std::vector<std::string> identities;
  for (const Run& run : runs) {
    const std::string own = identity(run);
    const auto known = std::find(identities.begin(), identities.end(), own);
    if (known == identities.end()) {
      identities.push_back(own);
      strategies.push_back({"", {&run}});
    } else {
      strategies[static_cast<std::size_t>(known - identities.begin())].runs.push_back(&run);
    }
  }
  give_names(strategies);
  return strategies;
}

std::vector<std::string> effective_lines(const std::string& scene_text) {
  std::vector<std::string> lines;
  std::istringstream text(scene_text);
  for (std::string line; std::getline(text, line);) {
    line = results::trimmed(without_comment(line), kBlanks);
    if (!line.empty() && !sets(line, "seed") && !sets(line, "title")) lines.push_back(line);
  }
  return lines;
}

bool series_over_speed(const std::vector<Strategy>& strategies) {
  std::set<std::vector<std::string>> scenes;
  std::set<double> speeds;
  for (const auto& strategy : strategies) {
    auto lines = effective_lines(strategy.first().scene_text);
    std::erase_if(lines, [](const std::string& line) { return sets(line, "velocity"); });
    scenes.insert(lines);
    const double speed = figure(strategy.first(), "shoe_speed_m_s");
    if (speed > 0) speeds.insert(speed);
  }
  return scenes.size() == 1 && strategies.size() > 1 && speeds.size() == strategies.size();
}

}  // namespace diefill::render::report
