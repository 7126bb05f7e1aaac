// What `check` and `run` report about a set-up that is probably a mistake.
#include <cstdio>
#include <nlohmann/json.hpp>

#include "app/tables/check_report.h"
#include "process/tooling/stages.h"

namespace diefill::app {

namespace {

constexpr int kMaxPlaces = 60;  // marks of one finding
constexpr int kWaySteps = 12;   // marks along the way of a shoe

render::FindingMark pour_mark(const process::PourSpec& pour) {
  render::FindingMark mark{render::MarkKind::kFact, "corners of the pour box", {}};
  for (int corner = 0; corner < 8; ++corner)
    mark.places.emplace_back((corner & 1) != 0 ? pour.upper.x() : pour.lower.x(),
                             (corner & 2) != 0 ? pour.upper.y() : pour.lower.y(),
                             (corner & 4) != 0 ? pour.lower.z() + pour.fill_height : pour.lower.z());
  return mark;
}

std::vector<Eigen::Vector3d> thinned(const std::vector<Eigen::Vector3d>& places) {
  std::vector<Eigen::Vector3d> some;
  const std::size_t every = 1 + places.size() / kMaxPlaces;
  for (std::size_t k = 0; k < places.size(); k += every) some.push_back(places[k]);
  return some;
}

}  // namespace

std::vector<render::FindingMark> marks_of(const process::Scene& scene,
                                          const std::vector<process::SetupFinding>& setup) {
  std::vector<render::FindingMark> marks;
  for (const auto& finding : setup)
    if (!finding.places.empty())
      marks.push_back({render::MarkKind::kFault, finding.words, thinned(finding.places)});
  marks.push_back(pour_mark(scene.pour));
  return marks;
}

render::FindingMark path_marker(const process::Scene& scene, const process::Tool& tool) {
  const process::Stages stages(scene);
  const auto states = process::predicted(stages, process::kSettlingGuess);
  const geometry::Box box = tool.mesh.bounding_box();
  const Eigen::Vector3d edge(0.5 * (box.lower.x() + box.upper.x()), 0.5 * (box.lower.y() + box.upper.y()),
                             box.lower.z());
  render::FindingMark mark{
      render::MarkKind::kFact, "path of " + tool.spec.name + ", middle of its lower edge", {edge}};
  for (const double time : process::instants(stages, states, kWaySteps)) {
    const auto pose = process::pose_of(stages, states, tool.spec.name, time);
    mark.places.push_back(pose.rotation * edge + pose.translation);
  }
  mark.places = thinned(mark.places);
  return mark;
}

nlohmann::ordered_json setup_as_json(const std::vector<process::SetupFinding>& setup) {
  auto json = nlohmann::ordered_json::array();
  for (const auto& finding : setup) {
    auto places = nlohmann::ordered_json::array();
    for (const auto& place : thinned(finding.places)) places.push_back({place[0], place[1], place[2]});
    json.push_back({{"text", finding.words}, {"places_m", places}});
  }
  return json;
}

void print_alerts(const std::vector<std::string>& lines) {
  if (lines.empty()) return;
  std::printf("WARNING\n");
  for (const auto& line : lines) std::printf("  ! %s\n", line.c_str());
  std::fflush(stdout);
}

std::vector<std::string> finding_lines(const std::vector<process::SetupFinding>& setup) {
  std::vector<std::string> words;
  for (const auto& finding : setup) words.push_back(finding.words);
  return words;
}

}  // namespace diefill::app
