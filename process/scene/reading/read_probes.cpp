#include <algorithm>

#include "process/input/scene_error.h"
#include "process/scene/reading/sections.h"
#include "process/scene/snapshot_folder.h"

namespace diefill::process {
namespace {

constexpr QuantityRule kInterval = {Dimension::time, "1 ms", "0 s", "1000 s", true};
constexpr QuantityRule kOrigin = {Dimension::length, "0 mm", "-10 m", "10 m"};

void refuse_taken(TableReader& table, const std::vector<std::string>& names, const std::string& name) {
  if (std::find(names.begin(), names.end(), name) != names.end())
    table.reject("name", "an earlier one already has this name; names must be unique");
}

const Choices<ProbeQuantity>& quantities() {
  static const Choices<ProbeQuantity> choices = {{"load", ProbeQuantity::load},
                                                 {"flow", ProbeQuantity::flow},
                                                 {"filled mass", ProbeQuantity::filled_mass},
                                                 {"fill level", ProbeQuantity::fill_level},
                                                 {"energy", ProbeQuantity::energy}};
  return choices;
}

void refuse_unknown_step(const Condition& condition, const Scene& scene) {
  for (const std::string* name : {&condition.after, &condition.with}) {
    const bool known =
        name->empty() || std::any_of(scene.steps.begin(), scene.steps.end(),
                                     [&](const auto& step) { return step->plan.name == *name; });
    if (!known)
      throw SceneError(condition.where + ": found \"" + *name +
                       "\", but no step has this name; add name = \"" + *name + '"');
  }
}

/// Two snapshots in one folder: the later one would replace the earlier.
void refuse_same_folder(TableReader& table, const std::vector<SnapshotSpec>& earlier,
                        const SnapshotSpec& snapshot) {
  for (const SnapshotSpec& other : earlier)
    if (have_same_folder(other, snapshot))
      table.reject("name", "an earlier snapshot, \"" + other.name +
                               "\", is kept in the same folder; give names that differ in a letter from a to "
                               "z or a digit");
}

}  // namespace

std::vector<ProbeSpec> read_probes(TableReader& document, const std::vector<ToolSpec>& tools) {
  Choices<std::string> names;
  for (const ToolSpec& tool : tools) names.emplace_back(tool.name, tool.name);
  std::vector<ProbeSpec> probes;
  std::vector<std::string> taken;
  for (TableReader& table : document.tables("probe")) {
    ProbeSpec probe;
    probe.name = table.required_name("name", "load on the punch");
    refuse_taken(table, taken, probe.name);
    taken.push_back(probe.name);
    probe.quantity = table.required_choice("quantity", quantities());
    probe.interval = table.quantity("interval", kInterval).value_or(probe.interval);
    if (probe.quantity == ProbeQuantity::load) probe.tool = table.required_choice("tool", names);
    if (probe.quantity == ProbeQuantity::flow) {
      probe.origin = table.required_point("origin", kOrigin);
      probe.normal = table.direction("normal").value_or(probe.normal);
    }
    table.finish();
    probes.push_back(probe);
  }
  return probes;
}

std::vector<SnapshotSpec> read_snapshots(TableReader& document, const Scene& scene) {
  std::vector<std::string> tools, taken;
  for (const ToolSpec& tool : scene.tools) tools.push_back(tool.name);
  std::vector<SnapshotSpec> snapshots;
  for (TableReader& table : document.tables("snapshot")) {
    SnapshotSpec snapshot;
    snapshot.name = table.required_name("name", "half filled");
    refuse_taken(table, taken, snapshot.name);
    taken.push_back(snapshot.name);
    snapshot.when = read_condition(table, "when", tools);
    if (snapshot.when) refuse_unknown_step(*snapshot.when, scene);
    snapshot.every = table.quantity("every", kInterval);
    refuse_same_folder(table, snapshots, snapshot);
    table.finish();
    snapshots.push_back(snapshot);
  }
  return snapshots;
}

}  // namespace diefill::process
