#include "process/run/restart/shared_start.h"

#include <toml++/toml.h>

#include "engine/numerics/fnv1a.h"
#include "process/machine/actions/powder_inflow.h"
#include "process/machine/step.h"
#include "process/results/storage/hash_text.h"
#include "process/results/storage/result_file.h"
#include "process/scene/scene_text.h"

namespace diefill::process {
namespace {

namespace fs = std::filesystem;

/// Whether the step can have touched the powder by `now`. Tools stand where they were at the instant a motion
/// begins; powder comes in or is cleared away at once.
bool has_acted(const Step& step, const StepState& state, double now) {
  if (state.is_pending()) return false;
  return state.started < now || step.inflow() != nullptr || step.removal() != nullptr ||
         step.change() != nullptr;
}

/// What the scene file says about a step that has yet to act: by when it may begin, and what others call it.
toml::table plan_of(const toml::table& step) {
  toml::table plan;
  for (const char* key : {"name", "start"})
    if (const toml::node* node = step.get(key)) plan.insert(key, *node);
  return plan;
}

/// What the table that a step follows holds is what acts, not how its file is called.
void name_by_contents(toml::table& step, const std::vector<InputFile>& inputs) {
  const auto file = step["file"].value_exact<std::string>();
  if (file) step.insert_or_assign("file", hash_of_input(inputs, *file));
}

/// Scenes may have more or fewer steps at the end, as long as nothing of them counts yet.
void drop_last_without_plan(toml::array& steps) {
  while (!steps.empty() && steps.back().as_table()->empty()) steps.pop_back();
}

/// The scene's text without what has no part in the run so far.
std::string text_so_far(const Scene& scene, const std::vector<InputFile>& inputs,
                        const ScheduleState& schedule, double now) {
  toml::table document = relevant_document(scene.text, scene.file);
  document.erase("snapshot");
  for (std::size_t k = 0; k < scene.steps.size(); ++k) {
    toml::table& step = *document["step"][k].as_table();
    // The first stage is the settling before the scene's own steps.
    if (!has_acted(*scene.steps[k], schedule.steps[k + 1], now))
      step = plan_of(step);
    else
      name_by_contents(step, inputs);
  }
  if (toml::array* steps = document["step"].as_array()) drop_last_without_plan(*steps);
  return scene_text_of(document);
}

/// What the files that the powder begins with hold, such as pour.state: their names say nothing of it.
void add_powder_files(engine::Fnv1a& hash, const Scene& scene, const std::vector<InputFile>& inputs) {
  toml::table document = relevant_document(scene.text, scene.file);
  document.erase("step");  // name_by_contents()
  for (const std::string& name : input_names(document)) hash.add(hash_of_input(inputs, name));
}

void add_vector(engine::Fnv1a& hash, const Eigen::Vector3d& vector) {
  hash.add(vector.data(), sizeof(double) * 3);
}

void add_box(engine::Fnv1a& hash, const geometry::Box& box) {
  add_vector(hash, box.lower);
  add_vector(hash, box.upper);
}

/// Tools as the engine has them. CAD as such counts too: measures and mesh walls are made from it.
void add_tools(engine::Fnv1a& hash, const Tooling& tooling) {
  for (const Tool& tool : tooling.tools) {
    hash.add(tool.file_hash);
    hash.add_number(tool.spheres.radius);
    for (const Eigen::Vector3d& centre : tool.spheres.centres) add_vector(hash, centre);
  }
  add_box(hash, tooling.all_cavities().box);
  hash.add_number(tooling.all_cavities().volume);
}

}  // namespace

std::uint64_t start_hash(const Scene& scene, const Tooling& tooling, const RunFrame& frame,
                         const ScheduleState& schedule, double now) {
  engine::Fnv1a hash;
  hash.add(text_so_far(scene, frame.inputs, schedule, now));
  add_powder_files(hash, scene, frame.inputs);
  hash.add_number(scene.seed);
  add_tools(hash, tooling);
  hash.add_number(frame.time_step);
  add_box(hash, frame.domain);
  return hash.value();
}

void save_shared_start(const fs::path& directory, const Checkpoint& checkpoint) {
  const fs::path file = directory / (results::hash_text(checkpoint.start_hash) + ".bin");
  if (!fs::exists(file)) write_checkpoint(file, checkpoint);
}

std::optional<ScheduleState> with_steps(ScheduleState schedule, std::size_t count) {
  for (std::size_t k = count; k < schedule.steps.size(); ++k)
    if (!schedule.steps[k].is_pending()) return std::nullopt;
  schedule.steps.resize(count);
  return schedule;
}

std::optional<Checkpoint> latest_shared_start(const fs::path& directory,
                                              const std::function<bool(const Checkpoint&)>& is_own) {
  std::optional<Checkpoint> latest;
  std::error_code missing;
  for (const auto& entry : fs::directory_iterator(directory, missing)) {
    std::optional<Checkpoint> checkpoint;
    try {
      checkpoint = read_checkpoint(entry.path());
    } catch (const results::ResultError&) {
      continue;
    }
    if (!checkpoint || !is_own(*checkpoint)) continue;
    if (!latest || checkpoint->simulation.time > latest->simulation.time) latest = std::move(checkpoint);
  }
  return latest;
}

}  // namespace diefill::process
