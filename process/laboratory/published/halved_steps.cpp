#include "process/laboratory/published/halved_steps.h"

#include <fstream>
#include <set>

#include "engine/limits/time_step.h"
#include "engine/limits/validity_monitor.h"
#include "process/laboratory/published/lab_powder.h"
#include "process/machine/ringing_watch.h"
#include "process/results/storage/atomic_file.h"

namespace diefill::process::laboratory {
namespace {

bool step_was_too_long(const JobState& state) {
  return state.out_of_range() && (state.reason.find(engine::kStepTooLong) != std::string::npos ||
                                  state.reason.find(kUnstableControl) != std::string::npos);
}

}  // namespace

std::map<std::string, int> halvings_of_runs(const std::filesystem::path& directory) {
  std::map<std::string, int> halvings;
  std::ifstream file(directory / kHalvedSteps);
  for (std::string name; std::getline(file, name);)
    if (!name.empty()) ++halvings[name];
  return halvings;
}

Scene at_half_step(const Scene& scene) {
  const NumericsSpec& numerics = scene.numerics;
  const double given = numerics.time_step_fraction;
  SceneChanges changes;
  changes.source = "half the time step";
  if (numerics.time_step)
    changes.set = line("numerics.time_step", with_unit(*numerics.time_step / 2, "s"));
  else
    changes.set = line("numerics.time_step_fraction",
                       plain((given > 0 ? given : engine::kDefaultTimeStepFraction) / 2));
  return changed_scene(scene.text, scene.file, changes);
}

bool halve_steps_that_were_too_long(const std::filesystem::path& directory, const results::JobList& list,
                                    const NoteCallback& on_note) {
  std::map<std::string, int> halvings = halvings_of_runs(directory);
  std::set<std::string> halved;  // now: seeds share a run's name
  for (const results::Job& job : list.jobs) {
    if (!step_was_too_long(state_of(directory, job)) || halvings[job.variant] >= kMostHalvings) continue;
    if (halved.insert(job.variant).second && on_note)
      on_note('"' + job.variant + "\" ended because its time step is too long: it runs again at half of it");
  }
  if (halved.empty()) return false;
  for (const std::string& name : halved) ++halvings[name];
  std::string text;
  for (const auto& [name, times] : halvings)
    for (int n = 0; n < times; ++n) text += name + '\n';
  results::write_text_atomically(directory / kHalvedSteps, text);
  return true;
}

}  // namespace diefill::process::laboratory
