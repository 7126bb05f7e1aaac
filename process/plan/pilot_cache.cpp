#include "process/plan/pilot_cache.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <system_error>
#include <vector>

#include "process/plan/plan.h"
#include "process/results/storage/atomic_file.h"
#include "process/results/storage/hash_text.h"
#include "process/results/storage/result_file.h"
#include "process/scene/identity.h"

namespace diefill::process::plan {

namespace {

namespace files = std::filesystem;
using Json = nlohmann::json;

constexpr int kFormat = 1;  // of the files; others are passed over

/// The processor as Linux names it.
std::string processor_name() {
  std::ifstream stream("/proc/cpuinfo");
  for (std::string line; std::getline(stream, line);)
    if (line.starts_with("model name")) return line;
  return {};
}

/// Which build of the program this is: its file's time and size.
std::string build_name() {
  std::error_code failed;
  const files::path program = files::read_symlink("/proc/self/exe", failed);
  if (failed) return {};
  const auto time = files::last_write_time(program, failed).time_since_epoch().count();
  return std::to_string(time) + "/" + std::to_string(files::file_size(program, failed));
}

/// FNV-1a.
std::uint64_t hash_of(const std::string& text) {
  std::uint64_t hash = 14695981039346656037ULL;
  for (const char letter : text) hash = (hash ^ static_cast<unsigned char>(letter)) * 1099511628211ULL;
  return hash;
}

std::string today() {
  const std::time_t now = std::time(nullptr);
  std::array<char, 32> text{};
  std::tm parts{};
  localtime_r(&now, &parts);
  std::strftime(text.data(), text.size(), "%Y-%m-%d %H:%M", &parts);
  return text.data();
}

Json as_json(const Pilot& pilot) {
  Json json = {{"format", kFormat},
               {"date", today()},
               {"grain_diameter_m", pilot.grain_diameter},
               {"fill_height_m", pilot.fill_height},
               {"time_step_s", pilot.time_step},
               {"fall_time_s", pilot.fall_time},
               {"spheres", pilot.spheres},
               {"wall_seconds", pilot.wall_seconds},
               {"processor_share", pilot.processor_share},
               {"rest_after_fall_s", pilot.rest.after_fall},
               {"rest_after_motion_s", pilot.rest.after_motion},
               {"stopped", pilot.stopped},
               {"cost", Json::array()},
               {"size", Json::array()}};
  for (const PhaseCost& cost : pilot.cost)
    json["cost"].push_back(
        {cost.wall_seconds, cost.sphere_steps, cost.seconds, cost.whole ? 1.0 : 0.0, cost.search_seconds});
  for (const auto& point : pilot.size.points)
    json["size"].push_back({point.spheres, point.seconds_per_sphere_step, point.search_seconds});
  return json;
}

/// Throws where the text is not what as_json() writes.
Pilot pilot_of(const Json& json) {
  if (json.at("format").get<int>() != kFormat) throw std::runtime_error("another format");
  Pilot pilot;
  pilot.cached_since = json.at("date").get<std::string>();
  pilot.grain_diameter = json.at("grain_diameter_m").get<double>();
  pilot.fill_height = json.at("fill_height_m").get<double>();
  pilot.time_step = json.at("time_step_s").get<double>();
  pilot.fall_time = json.at("fall_time_s").get<double>();
  pilot.spheres = json.at("spheres").get<std::size_t>();
  pilot.wall_seconds = json.at("wall_seconds").get<double>();
  pilot.processor_share = json.at("processor_share").get<double>();
  pilot.rest.after_fall = json.at("rest_after_fall_s").get<double>();
  pilot.rest.after_motion = json.at("rest_after_motion_s").get<double>();
  pilot.stopped = json.at("stopped").get<std::string>();
  for (std::size_t k = 0; k < pilot.cost.size(); ++k) {
    const auto numbers = json.at("cost").at(k).get<std::vector<double>>();
    pilot.cost[k] = {numbers.at(0), numbers.at(1), numbers.at(2), numbers.at(3) > 0, numbers.at(4)};
  }
  for (const auto& entry : json.at("size")) {
    const auto numbers = entry.get<std::vector<double>>();
    pilot.size.points.push_back({numbers.at(0), numbers.at(1), numbers.at(2)});
  }
  return pilot;
}

/// Removes the oldest beyond kMaxPilots.
void thin_out(const files::path& folder) {
  std::error_code failed;
  std::vector<std::pair<files::file_time_type, files::path>> kept;
  for (files::directory_iterator entry(folder, failed), end; !failed && entry != end; entry.increment(failed))
    if (entry->path().extension() == ".json")
      kept.emplace_back(entry->last_write_time(failed), entry->path());
  if (kept.size() <= kMaxPilots) return;
  std::sort(kept.begin(), kept.end());
  for (std::size_t k = 0; k + kMaxPilots < kept.size(); ++k) files::remove(kept[k].second, failed);
}

}  // namespace

files::path pilot_cache_folder() {
  const char *cache = std::getenv("XDG_CACHE_HOME"), *home = std::getenv("HOME");
  if (cache != nullptr && *cache == '/') return files::path(cache) / "diefill" / "pilots";
  if (home != nullptr && *home == '/') return files::path(home) / ".cache" / "diefill" / "pilots";
  return {};
}

std::string pilot_name(const Scene& scene, const Tooling& tooling, int threads, double wall_limit) {
  std::vector<std::string> tools;
  for (const Tool& tool : tooling.tools) tools.push_back(tool.file_hash);
  std::array<char, 256> machine{};
  gethostname(machine.data(), machine.size() - 1);
  std::ostringstream text;
  text << scene_identity(scene.text, scene.file, tools) << '|' << threads << '|' << wall_limit << '|'
       << machine.data() << '|' << processor_name() << '|' << build_name();
  return results::hash_text(hash_of(text.str()));
}

std::optional<Pilot> cached_pilot(const files::path& folder, const std::string& name) {
  if (folder.empty()) return std::nullopt;
  try {
    std::ifstream stream(folder / (name + ".json"));
    if (!stream) return std::nullopt;
    return pilot_of(Json::parse(stream));
  } catch (const std::exception&) {
    return std::nullopt;  // half written by hand, or of another version: it is found out again
  }
}

void store_pilot(const files::path& folder, const std::string& name, const Pilot& pilot) {
  if (folder.empty()) return;
  std::error_code failed;
  files::create_directories(folder, failed);
  if (failed) return;
  try {
    results::write_text_atomically(folder / (name + ".json"),
                                   as_json(pilot).dump(1, ' ', false, Json::error_handler_t::replace));
    thin_out(folder);
  } catch (const results::ResultError&) {
    return;  // a full disk: the plan is as good without
  }
}

Pilot pilot_for(const Scene& scene, const Tooling& tooling, const PlanOptions& options) {
  const auto run = [&] {
    if (options.pilot_starts) options.pilot_starts();
    return run_pilot(scene, tooling, options.threads, options.pilot_limit);
  };
  if (options.pilots.empty()) return run();
  const std::string name = pilot_name(scene, tooling, options.threads, options.pilot_limit);
  if (!options.new_pilot)
    if (auto kept = cached_pilot(options.pilots, name)) return *kept;
  Pilot pilot = run();
  store_pilot(options.pilots, name, pilot);
  return pilot;
}

}  // namespace diefill::process::plan
