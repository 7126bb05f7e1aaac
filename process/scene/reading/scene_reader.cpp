#include <toml++/toml.h>

#include "engine/simulation/standard_gravity.h"
#include "process/machine/actions/powder_change.h"
#include "process/scene/contact/contact_spec.h"
#include "process/scene/powder/powder_file.h"
#include "process/scene/reading/free_tools.h"
#include "process/scene/reading/graded_pour.h"
#include "process/scene/reading/sections.h"
#include "process/scene/scene.h"
#include "process/scene/scene_text.h"
#include "process/scene/setting.h"

namespace diefill::process {
namespace {

constexpr QuantityRule kGravity = {Dimension::acceleration, "9.81 m/s^2", "0 m/s^2", "1000 m/s^2"};
constexpr double kWeakestGravity = 0.01;  // m/s^2
constexpr QuantityRule kGravityAlongAxis = {Dimension::acceleration, "-9.81 m/s^2", "-1000 m/s^2",
                                            "1000 m/s^2"};

/// A table that may be left out, for the sake of its defaults.
TableReader table_or_empty(TableReader& document, const std::string& key, const toml::table& empty) {
  const auto table = document.table(key);
  return table ? *table : TableReader(empty, document.file(), key);
}

/// Openings between centres are a matter of wall spheres.
void check_opening(const TableReader& numerics, const Scene& scene) {
  if (scene.numerics.opening != OpeningMeasure::centres) return;
  for (const ToolSpec& tool : scene.tools)
    if (tool.walls.value_or(scene.walls.kind) == WallKind::mesh)
      numerics.reject("opening",
                      "\"centres\" puts the centres of wall spheres on the CAD surface, but tool \"" +
                          tool.name + "\" has none (walls = \"mesh\"); remove one of the two");
}

/// Laws that steps of kind "change" name.
void read_step_contacts(TableReader& document, Scene& scene) {
  auto tables = document.tables("step");
  for (std::size_t k = 0; k < scene.steps.size(); ++k)
    scene.steps[k] = with_contact_of(document, tables[k], scene.steps[k], scene);
}

/// One number points downwards; three are a vector.
Eigen::Vector3d read_gravity(TableReader& document) {
  if (document.has_list("gravity")) return *document.point("gravity", kGravityAlongAxis);
  return {0, 0, -document.quantity("gravity", kGravity).value_or(engine::kStandardGravity)};
}

/// Steps wait until the powder rests, and powder without weight may never do so.
void refuse_endless_flight(const TableReader& document, const Scene& scene) {
  if (scene.numerics.max_time > 0) return;
  double weakest = scene.gravity.norm();
  for (const auto& step : scene.steps)
    if (const PowderChange* change = step->change(); change != nullptr && change->gravity)
      weakest = std::min(weakest, change->gravity->norm());
  if (weakest >= kWeakestGravity) return;
  document.reject("gravity",
                  "powder under " + number_text(weakest) +
                      " m/s^2 may never come to rest, and the run would not end; allowed: at least " +
                      number_text(kWeakestGravity) + " m/s^2, or any with numerics.max_time = \"5 s\" or so");
}

}  // namespace

Scene scene_of(toml::table& parsed, const std::string& text, const std::filesystem::path& file,
               const WrittenKeys& written) {
  const toml::table empty;
  const bool stands_in_two_files = merge_powder_file(parsed, file);
  const std::string stated =
      stands_in_two_files ? as_comment(chosen_numbers_in(text)) + scene_text_of(parsed) : text;
  apply_graded_pour(parsed, file);
  TableReader document(parsed, file, "", &written);
  Scene scene;
  scene.file = file;
  scene.text = stated;
  scene.title = document.text("title").value_or(file.stem().string());
  scene.seed = static_cast<std::uint64_t>(document.integer("seed", 0, INT64_MAX).value_or(1));
  scene.gravity = read_gravity(document);
  const auto setting = read_setting(document);
  TableReader powder = document.required_table("powder");
  scene.coarse_graining = read_coarse_graining(powder);
  scene.powder = read_powder(powder);
  scene.walls = read_walls(table_or_empty(document, "walls", empty), scene.powder);
  if (auto contact = read_contact(document, scene.powder, scene.walls))
    scene.contact = std::make_shared<const ContactSpec>(std::move(*contact));
  read_other_powders(document, scene);
  scene.tools = read_tools(document, scene.walls, scene.powder);
  const TableReader numerics = table_or_empty(document, "numerics", empty);
  scene.numerics = read_numerics(numerics, scene.powder);
  check_opening(numerics, scene);
  const TableReader pour = document.required_table("pour");
  scene.pour = setting ? read_pour_without_height(pour, scene) : read_pour(pour, scene);
  scene.steps = read_steps(document, scene.tools);
  read_step_contacts(document, scene);
  refuse_endless_flight(document, scene);
  check_mixture(document, scene);
  scene.probes = read_probes(document, scene.tools);
  scene.snapshots = read_snapshots(document, scene);
  scene.measure = read_measure(table_or_empty(document, "measure", empty), scene.powder);
  read_economy(table_or_empty(document, "economy", empty), scene);
  if (auto suction = document.table("suction")) scene.suction = read_suction(*suction, scene);
  refuse_free_tools_beside(scene);
  document.tables("variant");  // no matter of this scene's own: see variants.h
  document.finish();
  return scene;
}

Scene parse_scene(const std::string& text, const std::filesystem::path& file) {
  toml::table document = parse_scene_text(text, file);
  return scene_of(document, text, file);
}

Scene read_scene(const std::filesystem::path& file) {
  return parse_scene(load_scene_text(file), file);
}

std::string strategy_text(const Scene& scene) {
  std::string words;
  for (const auto& step : scene.steps) {
    // Coming to rest goes without saying.
    if (step->tools().empty() && step->open_ended() && step->inflow() == nullptr) continue;
    // A step that starts by a rule of its own need not come after the one before it.
    words += (words.empty()                                         ? ""
              : step->plan.start && !step->plan.start->with.empty() ? " with "
                                                                    : ", then ") +
             step->description();
  }
  return words.empty() ? "no motion" : words;
}

}  // namespace diefill::process
