#include "app/tables/plan_report.h"

#include <algorithm>
#include <cstdio>
#include <functional>
#include <nlohmann/json.hpp>

#include "app/tables/pilot_report.h"
#include "process/results/formatted.h"
#include "process/tooling/progress.h"

namespace diefill::app {

namespace {

using Json = nlohmann::ordered_json;
namespace plan = process::plan;

/// A line of the table: its text for each choice.
struct Row {
  const char* name;
  std::function<std::string(const plan::Choice&)> cell;
};

std::string count(double number) {
  return results::formatted("%.0f", number);
}

std::string time_of(const plan::Choice& choice) {
  const auto& seconds = choice.forecast.wall_seconds;
  return seconds ? process::duration_text(*seconds) : "unknown";
}

/// With the share of the processors that the pilot got.
std::string busy_time_of(const plan::Choice& choice, double share) {
  const auto& seconds = choice.forecast.wall_seconds;
  return seconds ? process::duration_text(*seconds / share) : "unknown";
}

/// What is expected of one quantity, "3.1 +- 1.2 %" with the scatter of a run.
std::string error_of(const plan::Choice& choice, const std::string& quantity) {
  for (const auto& error : choice.errors)
    if (error.quantity == quantity)
      return error.scatter > 0 ? results::formatted("%.1f +- %.1f %%", 100 * error.error, 100 * error.scatter)
                               : results::formatted("%.1f %%", 100 * error.error);
  return "unknown";
}

const std::vector<Row>& rows() {
  using Choice = plan::Choice;
  static const std::vector<Row> all = {
      {"grain diameter, mm",
       [](const Choice& c) { return results::formatted("%.4g", 1e3 * c.forecast.grain_diameter); }},
      {"powder in the shoe, mm",
       [](const Choice& c) { return results::formatted("%.4g", 1e3 * c.forecast.fill_height); }},
      {"grains", [](const Choice& c) { return count(static_cast<double>(c.forecast.grains)); }},
      {"spheres", [](const Choice& c) { return count(static_cast<double>(c.forecast.spheres)); }},
      {"wall spheres", [](const Choice& c) { return count(static_cast<double>(c.forecast.wall_spheres)); }},
      {"time step, us",
       [](const Choice& c) { return results::formatted("%.3g", 1e6 * c.forecast.time_step); }},
      {"steps", [](const Choice& c) { return count(c.forecast.steps()); }},
      {"simulated time, s", [](const Choice& c) { return results::formatted("%.3g", c.forecast.seconds()); }},
      {"memory, MB", [](const Choice& c) { return results::formatted("%.0f", 1e-6 * c.forecast.memory); }},
      {"time, free processors", time_of},
  };
  return all;
}

/// A line for every quantity that any choice has an error of.
void print_errors(const plan::Plan& plan) {
  std::vector<std::string> quantities;
  for (const auto& choice : plan.choices)
    for (const auto& error : choice.errors)
      if (std::find(quantities.begin(), quantities.end(), error.quantity) == quantities.end())
        quantities.push_back(error.quantity);
  if (quantities.empty()) quantities.emplace_back("filling");
  std::printf("expected error of\n");
  for (const auto& quantity : quantities) {
    std::printf("  %-22s", quantity.c_str());
    for (const auto& choice : plan.choices) std::printf("%20s", error_of(choice, quantity).c_str());
    std::printf("\n");
  }
}

void print_table(const plan::Plan& plan) {
  std::printf("\n%-24s", "");
  for (const auto& choice : plan.choices) std::printf("%20s", choice.name.c_str());
  std::printf("\n");
  for (const Row& row : rows()) {
    std::printf("%-24s", row.name);
    for (const auto& choice : plan.choices) std::printf("%20s", row.cell(choice).c_str());
    std::printf("\n");
  }
  if (plan.pilot && is_busy(*plan.pilot)) {
    std::printf("%-24s",
                results::formatted("time, busy at %.0f %%", 100 * plan.pilot->processor_share).c_str());
    for (const auto& choice : plan.choices)
      std::printf("%20s", busy_time_of(choice, plan.pilot->processor_share).c_str());
    std::printf("\n");
  }
  print_errors(plan);
  std::printf("\n");
}

/// Each source once.
void print_error_sources(const plan::Plan& plan) {
  std::vector<std::string> printed;
  for (const auto& choice : plan.choices)
    for (const auto& error : choice.errors) {
      const std::string line = error.quantity + ": " + error.source;
      if (std::find(printed.begin(), printed.end(), line) != printed.end()) continue;
      printed.push_back(line);
      std::printf("expected error of the %s\n", line.c_str());
    }
  std::printf(
      printed.empty()
          ? "expected errors are not known here: the grain diameter over the narrowest width is outside the "
            "range of the reference runs, or there is no cavity\n"
          : "expected errors are those of the grain size, +- the scatter of one run over seeds\n");
}

void print_sources(const plan::Plan& plan) {
  for (const auto& choice : plan.choices) {
    if (!choice.numbers) continue;
    std::printf("%s: ", choice.name.c_str());
    for (std::size_t k = 0; k < choice.numbers->reasons.size(); ++k)
      std::printf("%s%s", k == 0 ? "" : "; ", choice.numbers->reasons[k].c_str());
    std::printf("\n");
  }
  if (plan.pilot) print_pilot(*plan.pilot);
  std::printf("reading the tools took %.1f s\n", plan.tooling_seconds);
  print_error_sources(plan);
}

Json phase_as_json(const plan::PhaseForecast& part) {
  return {{"kind", plan::description(part.phase.kind)},
          {"simulated_s", part.phase.seconds},
          {"share_of_grains", part.phase.share},
          {"steps", part.steps},
          {"wall_seconds", part.wall_seconds > 0 ? Json(part.wall_seconds) : Json(nullptr)}};
}

Json needs_as_json(const plan::Needs& needs) {
  Json json;
  const auto& place = needs.cavity.narrowest_place;
  json["narrowest_width_m"] = needs.cavity.found ? Json(needs.cavity.narrowest_width) : Json(nullptr);
  json["narrowest_place_m"] = needs.cavity.found ? Json{place[0], place[1], place[2]} : Json(nullptr);
  json["coarsest_grain_m"] = needs.coarsest_grain > 0 ? Json(needs.coarsest_grain) : Json(nullptr);
  json["width_as_felt_m"] = needs.coarsest_grain > 0 ? Json(needs.effective_width) : Json(nullptr);
  json["time_step_s"] = needs.time_step;
  json["critical_time_step_s"] = needs.critical_step;
  json["impact_speed_m_per_s"] = needs.impact_speed;
  json["weight_pressure_pa"] = needs.weight_pressure;
  json["piston_pressure_pa"] = needs.piston_pressure;
  json["reduced_modulus_pa"] = needs.modulus;
  json["least_modulus_pa"] = needs.least_modulus;
  json["mirror_planes"] = Json::array();
  for (const auto& plane : needs.planes)
    json["mirror_planes"].push_back({{"normal", {plane.normal[0], plane.normal[1], plane.normal[2]}},
                                     {"offset_m", plane.offset},
                                     {"spoiled_by", plane.asymmetry}});
  json["laws"] = needs.laws.used;
  json["left_out"] = needs.laws.left_out;
  return json;
}

}  // namespace

void print_plan(const plan::Plan& plan) {
  for (const auto& statement : plan.statements) std::printf("%s\n", statement.c_str());
  print_table(plan);
  print_sources(plan);
}

std::string scene_lines(const process::Scene& scene, const plan::SettingNumbers& numbers) {
  return results::formatted("%s = \"%.4g mm\", walls.spacing = %.2g, pour.fill_height = \"%.4g mm\"",
                            scene.powder.sizes.empty() ? "powder.grain_diameter" : "powder.sizes.mean_size",
                            1e3 * numbers.grain_diameter, numbers.wall_spacing, 1e3 * numbers.fill_height);
}

Json choice_as_json(const plan::Choice& choice) {
  const auto& forecast = choice.forecast;
  Json json = {{"name", choice.name},
               {"grain_diameter_m", forecast.grain_diameter},
               {"fill_height_m", forecast.fill_height},
               {"time_step_s", forecast.time_step},
               {"critical_time_step_s", forecast.critical_step},
               {"grains", forecast.grains},
               {"spheres", forecast.spheres},
               {"wall_spheres", forecast.wall_spheres},
               {"steps", forecast.steps()},
               {"simulated_s", forecast.seconds()},
               {"memory_bytes", forecast.memory},
               {"wall_seconds", forecast.wall_seconds ? Json(*forecast.wall_seconds) : Json(nullptr)},
               {"wall_seconds_as_busy", nullptr},
               {"expected_errors", Json::array()},
               {"reasons", choice.numbers ? choice.numbers->reasons : std::vector<std::string>{}},
               {"phases", Json::array()}};
  for (const auto& error : choice.errors)
    json["expected_errors"].push_back({{"quantity", error.quantity},
                                       {"error", error.error},
                                       {"scatter", error.scatter > 0 ? Json(error.scatter) : Json(nullptr)},
                                       {"source", error.source}});
  for (const auto& part : forecast.phases) json["phases"].push_back(phase_as_json(part));
  return json;
}

Json plan_as_json(const plan::Plan& plan) {
  Json json = {{"title", plan.scene.title},
               {"needs", needs_as_json(plan.needs)},
               {"statements", plan.statements},
               {"tooling_seconds", plan.tooling_seconds},
               {"pilot", plan.pilot ? pilot_as_json(*plan.pilot) : Json(nullptr)},
               {"choices", Json::array()}};
  for (const auto& choice : plan.choices) {
    json["choices"].push_back(choice_as_json(choice));
    if (plan.pilot && choice.forecast.wall_seconds)
      json["choices"].back()["wall_seconds_as_busy"] =
          *choice.forecast.wall_seconds / plan.pilot->processor_share;
  }
  return json;
}

}  // namespace diefill::app
