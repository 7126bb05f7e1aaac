#include "app/commands/shared_options/scene_choice.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <cstdio>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>

#include "app/commands/ranks/step_engine.h"
#include "app/options/choices.h"
#include "app/stop_signals.h"
#include "process/input/scene_error.h"
#include "process/plan/setting.h"
#include "process/plan/variant_setting.h"
#include "process/powder/material.h"
#include "process/scene/given_changes.h"
#include "process/scene/scene_text.h"
#include "process/setup/build_tooling.h"
#include "process/setup/predicted_work.h"

namespace diefill::app {

namespace {

// Ratio of grain radius to wall sphere radius: a note is printed from the first on and proposes the second.
constexpr double kFineWalls = 12, kUsualWalls = 5;

/// A note for wall spheres far finer than the powder, which take long to place.
std::optional<std::string> fine_walls(const process::Scene& scene) {
  const double grain = 0.5 * process::largest_grain(scene), wall = scene.walls.sphere_radius;
  if (scene.walls.kind == process::WallKind::mesh || grain < kFineWalls * wall) return std::nullopt;
  char text[300];
  std::snprintf(
      text, sizeof text,
      "note: walls.sphere_radius is %.3g mm, 1/%.0f of the grain radius of %.3g mm: placing so "
      "many wall spheres is slow; %.2g mm, a fifth of the grain radius, needs about %.0f times fewer",
      1e3 * wall, grain / wall, 1e3 * grain, 1e3 * grain / kUsualWalls,
      std::pow(grain / (kUsualWalls * wall), 2));
  return text;
}

/// Work that has written nothing: a signal ends it. On ranks their parent says so.
class SetUp {
 public:
  SetUp() {
    if (step_engine() == nullptr) stop_.emplace();
  }

 private:
  std::optional<StopDuringSetUp> stop_;
};

/// Repeats the line of progress during long operations, not only when the next one begins.
class Ticker {
 public:
  Ticker(process::Progress& progress, bool wanted) : progress_(progress) {
    if (wanted) thread_ = std::jthread([this](const std::stop_token& stop) { tick(stop); });
  }
  void show(double share, const std::string& doing) {
    const std::lock_guard lock(mutex_);
    share_ = share;
    doing_ = doing;
    progress_.show(share_, doing_, "");
  }

 private:
  void tick(const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    while (!stop.stop_requested()) {
      wake_.wait_for(lock, stop, std::chrono::milliseconds(500), [] { return false; });
      if (!stop.stop_requested() && !doing_.empty()) progress_.show(share_, doing_, "");
    }
  }

  process::Progress& progress_;
  std::mutex mutex_;
  std::condition_variable_any wake_;
  double share_ = 0;
  std::string doing_;
  std::jthread thread_;  ///< last, so that it ends before the other members are destroyed
};

}  // namespace

CLI::Option* add_setting(CLI::App& command, std::string& setting) {
  return command
      .add_option(
          "--setting", setting,
          "use the planner's grain diameter, time step, wall spacing and fill height instead of those "
          "of the scene")
      ->check(one_of(process::setting_names()));
}

void print_setting_choices(const process::Scene& scene) {
  const auto chosen = process::chosen_numbers_in(scene.text);
  for (std::size_t k = 0; k < chosen.size(); ++k)
    std::fprintf(stderr, k == 0 ? "%s:\n" : "  %s\n", chosen[k].c_str());
}

CLI::Option* add_changes(CLI::App& command, std::vector<std::string>& changes) {
  return command
      .add_option(
          "--set", changes,
          "change a key of the scene, such as 'step.1.velocity = \"0.1 m/s\"'; may be given several times")
      ->allow_extra_args(false);
}

CLI::Option* add_variant(CLI::App& command, std::string& variant) {
  return command.add_option("--variant", variant, "take this [[variant]] of the scene, by its name");
}

process::Scene changed_scene(const std::string& file, const std::vector<std::string>& changes) {
  if (changes.empty()) return process::read_scene(file);
  process::refuse_changes_of_nothing(changes);
  process::SceneChanges wanted;
  for (const auto& change : changes) wanted.set += change + '\n';
  return process::changed_scene(process::load_scene_text(file), file, wanted);
}

std::vector<std::filesystem::path> input_files_of(const process::Scene& scene) {
  std::vector<std::filesystem::path> files = {scene.file};
  process::scene_text_with(scene, scene.seed, [&](const std::filesystem::path& file) {
    files.push_back(file);
    return file.string();
  });
  return files;
}

process::Scene chosen_scene(const std::string& file, const std::string& setting,
                            const std::vector<std::string>& changes) {
  const SetUp set_up;
  std::optional<process::Setting> wanted;
  if (!setting.empty()) wanted = process::setting_named(setting);
  auto scene = process::plan::scene_with_setting(changed_scene(file, changes), wanted);
  process::refuse_excessive_work(scene);
  print_setting_choices(scene);
  return scene;
}

std::vector<process::Variant> chosen_variants(const std::string& file, const std::string& setting) {
  const SetUp set_up;
  auto variants = process::read_variants(file);
  if (setting.empty()) {
    for (const auto& variant : variants)
      if (!process::setting_of(variant.scene)) process::refuse_excessive_work(variant.scene);
    return variants;
  }
  variants = process::plan::with_setting(std::move(variants), process::setting_named(setting));
  std::vector<std::string> printed;
  for (const auto& variant : variants) {
    const auto chosen = process::chosen_numbers_in(variant.scene.text);
    if (chosen == printed) continue;
    std::fprintf(stderr, "from \"%s\" on, ", variant.name.c_str());
    print_setting_choices(variant.scene);
    printed = chosen;
  }
  return variants;
}

std::vector<std::string> names_of_variants(const std::string& file) {
  std::vector<std::string> names;
  if (!process::has_variants(process::read_scene(file))) return names;
  for (const auto& variant : process::read_variants(file)) names.push_back(variant.name);
  return names;
}

process::Scene chosen_variant(const std::string& file, const std::string& name, const std::string& setting) {
  const auto names = names_of_variants(file);
  if (names.empty()) throw process::SceneError("--variant: " + file + " has no [[variant]]");
  const auto at = std::find(names.begin(), names.end(), name);
  if (at == names.end()) throw process::SceneError("--variant: " + unknown_name(name, names));
  const auto variants = chosen_variants(file, setting);
  auto scene = process::plan::scene_with_setting(variants[static_cast<std::size_t>(at - names.begin())].scene,
                                                 std::nullopt);
  process::refuse_excessive_work(scene);
  if (setting.empty()) print_setting_choices(scene);
  return scene;
}

process::Tooling prepared_tooling(const process::Scene& scene, bool show_progress) {
  const SetUp set_up;
  process::Progress progress(show_progress);
  if (const auto remark = fine_walls(scene)) progress.note(*remark);
  Ticker ticker(progress, show_progress);
  const double sphere = process::smallest_sphere(process::engine_settings(scene, 1.0));
  return process::build_tooling(scene, sphere, process::largest_grain(scene),
                                [&](double share, const std::string& doing) { ticker.show(share, doing); });
}

}  // namespace diefill::app
