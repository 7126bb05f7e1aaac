#include <cmath>
#include <nlohmann/json.hpp>

#include "process/results/cavity_rows.h"
#include "process/results/figure_table.h"
#include "process/results/json_numbers.h"
#include "process/results/no_value.h"
#include "process/results/storage/atomic_file.h"
#include "process/results/storage/result_file.h"

namespace diefill::results {
namespace {

using Json = nlohmann::ordered_json;

Json figure(const std::string& name, double value) {
  const bool whole = counts(name) && std::isfinite(value) && std::abs(value) < 9e15;
  return whole ? Json(std::llround(value)) : json_number(value);
}

Json summary(const SolidFractionSummary& solid_fraction) {
  return {{"mean", json_number(solid_fraction.mean)},
          {"arithmetic_mean", json_number(solid_fraction.arithmetic_mean)},
          {"std", json_number(solid_fraction.std)},
          {"min", json_number(solid_fraction.min)},
          {"max", json_number(solid_fraction.max)},
          {"cv", json_number(solid_fraction.cv)},
          {"grains", solid_fraction.grains}};
}

/// Numbers that the state itself gives, for runs that did not put them among the figures.
std::map<std::string, double> all_figures(const FillResult& result) {
  std::map<std::string, double> figures = result.figures;
  const auto count = [](std::size_t n) { return static_cast<double>(n); };
  std::size_t wall_spheres = 0;
  for (const ToolState& tool : result.tools) wall_spheres += tool.wall_sphere_centres.size();
  const std::size_t grains = result.powder.position.size();
  figures.emplace("grains", count(grains));
  figures.emplace("spheres", count(result.powder.sphere_count()));
  figures.emplace("wall_spheres", count(wall_spheres));
  figures.emplace("simulated_s", result.powder.time);
  for (const char* name : {"filled_mass_kg", "steps", "time_step_s", "wall_seconds",
                           "sphere_steps_per_second", "energy_balance_error"})
    figures.emplace(name, std::nan(""));
  return figures;
}

/// What each cavity holds, for a die with several.
Json cavities(const std::vector<CavityRow>& rows) {
  Json list = Json::array();
  for (const CavityRow& row : rows)
    list.push_back({{"number", row.number},
                    {"x_m", json_number(row.place.x())},
                    {"y_m", json_number(row.place.y())},
                    {"volume_m3", json_number(row.volume)},
                    {"mass_kg", json_number(row.mass)},
                    {"mass_is_estimate", row.estimate},
                    {"full_die_mass_kg", json_number(row.full_mass)},
                    {"fill_ratio", json_number(row.fill_ratio)},
                    {"fill_height_m", json_number(row.fill_height)},
                    {"depth_m", json_number(row.depth)},
                    {"solid_fraction", json_number(row.solid_fraction)},
                    {"solid_fraction_std", json_number(row.std)},
                    {"grains", row.grains},
                    {"verdict", row.verdict}});
  return list;
}

/// Why figures without a value have none, by their names.
Json reasons(const FillResult& result) {
  Json json = Json::object();
  for (const Topic& topic : result.topics)
    if (topic.topic == kNoValueTopic)
      for (std::size_t k = 0; k < topic.name.size(); ++k) json[topic.name[k]] = topic.text[k];
  return json;
}

Json profile(const Profile& curve) {
  return {{"quantity", curve.quantity}, {"unit", curve.unit},         {"x_name", curve.x_name},
          {"x_unit", curve.x_unit},     {"x", json_numbers(curve.x)}, {"y", json_numbers(curve.y)}};
}

Json report(const FillResult& result) {
  std::map<std::string, double> figures = all_figures(result);
  Json json;
  const auto take = [&](const char* name) {
    json[name] = figure(name, figures.at(name));
    figures.erase(name);
  };
  json["title"] = result.title;
  json["strategy"] = result.strategy;
  json["powder"] = result.powder_name;
  if (const auto finished = figures.find("finished"); finished != figures.end()) {
    json["finished"] = finished->second != 0;
    figures.erase(finished);
  }
  const auto rows = cavity_rows(result);
  if (!rows.empty() && !rows.front().verdict.empty()) json["verdict"] = rows.front().verdict;
  take("filled_mass_kg");
  json["solid_fraction"] = summary(result.summary);
  for (const char* name : {"grains", "spheres", "wall_spheres", "steps", "time_step_s", "simulated_s",
                           "wall_seconds", "sphere_steps_per_second", "energy_balance_error"})
    take(name);
  json["state_hash"] = result.state_hash;
  json["seed"] = result.seed;
  json["program_version"] = result.program_version;
  json["warnings"] = result.warnings;
  for (const Topic& topic : result.topics)
    if (topic.topic == "setting")
      for (std::size_t k = 0; k < topic.name.size(); ++k) json["setting"][topic.name[k]] = topic.text[k];
  json["phase_seconds"] = Json::object();
  for (const auto& [phase, seconds] : result.phase_seconds)
    json["phase_seconds"][phase] = json_number(seconds);
  for (const auto& [name, value] : figures) json.emplace(name, figure(name, value));
  if (rows.size() > 1) json["cavities"] = cavities(rows);
  if (const Json why = reasons(result); !why.empty()) json["no_value"] = why;
  for (const Profile& curve : result.profiles)
    if (curve.quantity == "fill level")
      json["fill_level"] = profile(curve);
    else if (curve.quantity == "mean grain diameter")
      json["size_profiles"].push_back(profile(curve));
  return json;
}

}  // namespace

void write_report(const std::filesystem::path& directory, const FillResult& result) {
  std::error_code error;
  std::filesystem::create_directories(directory, error);
  // Bytes that are no UTF-8 (from a scene's title, say) become replacement characters instead of an error.
  const std::string text = report(result).dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
  write_text_atomically(directory / "report.json", text);
}

}  // namespace diefill::results
