#include "process/laboratory/published/halved_steps.h"

#include <fstream>

#include "engine/limits/time_step.h"
#include "engine/limits/validity_monitor.h"
#include "process/laboratory/published/lab_powder.h"
#include "process/results/storage/atomic_file.h"

namespace diefill::process::laboratory {

std::set<std::string> runs_at_half_step(const std::filesystem::path& directory) {
  std::set<std::string> runs;
  std::ifstream file(directory / kHalvedSteps);
  for (std::string name; std::getline(file, name);)
    if (!name.empty()) runs.insert(name);
  return runs;
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
  std::set<std::string> runs = runs_at_half_step(directory);
  const std::size_t before = runs.size();
  for (const results::Job& job : list.jobs) {
    const JobState state = state_of(directory, job);
    const bool too_long =
        state.out_of_range() && state.reason.find(engine::kStepTooLong) != std::string::npos;
    if (too_long && runs.insert(job.variant).second && on_note)
      on_note('"' + job.variant + "\" ended because its time step is too long: it runs again at half of it");
  }
  if (runs.size() == before) return false;
  std::string text;
  for (const std::string& name : runs) text += name + '\n';
  results::write_text_atomically(directory / kHalvedSteps, text);
  return true;
}

}  // namespace diefill::process::laboratory
