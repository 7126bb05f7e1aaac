#include "app/tables/comparison_plan_report.h"

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "app/tables/pilot_report.h"
#include "app/tables/text_column.h"
#include "process/results/json_numbers.h"
#include "process/tooling/progress.h"

namespace diefill::app {

namespace {

using Json = nlohmann::ordered_json;
namespace plan = process::plan;

std::string time_text(const std::optional<double>& seconds) {
  return seconds ? process::duration_text(*seconds) : "unknown";
}

void print_table(const std::vector<plan::VariantForecast>& variants) {
  std::size_t width = 8;
  for (const auto& variant : variants)
    width = std::max(width, std::min(kWidestName, character_count(variant.name)));
  std::printf("\n%s%10s%10s%13s%11s%12s%14s\n", padded("variant", width).c_str(), "spheres", "steps",
              "simulated, s", "shared, s", "memory, MB", "wall time");
  for (const auto& variant : variants)
    std::printf("%s%10zu%10.0f%13.3g%11.3g%12.0f%14s\n", padded(variant.name, width).c_str(),
                variant.forecast.spheres, variant.forecast.steps(), variant.forecast.seconds(),
                variant.shared_seconds, 1e-6 * variant.forecast.memory,
                time_text(variant.wall_seconds).c_str());
}

Json variant_as_json(const plan::VariantForecast& variant) {
  const auto& forecast = variant.forecast;
  return {{"name", variant.name},
          {"grain_diameter_m", forecast.grain_diameter},
          {"time_step_s", forecast.time_step},
          {"grains", forecast.grains},
          {"spheres", forecast.spheres},
          {"wall_spheres", forecast.wall_spheres},
          {"steps", forecast.steps()},
          {"simulated_s", forecast.seconds()},
          {"shared_s", variant.shared_seconds},
          {"memory_bytes", forecast.memory},
          {"wall_seconds_alone", results::json_number(forecast.wall_seconds)},
          {"wall_seconds", results::json_number(variant.wall_seconds)}};
}

}  // namespace

void print_comparison_plan(const std::string& title, const plan::ComparisonForecast& comparison,
                           int threads) {
  std::printf("%s: %zu variants\n", title.c_str(), comparison.variants.size());
  print_table(comparison.variants);
  std::printf("\nall variants one after the other on %d threads (diefill compare): %s\n", threads,
              time_text(comparison.wall_seconds).c_str());
  std::printf(
      "shared: start that an earlier variant has already computed; wall time covers the rest, for one "
      "seed\n");
  for (const auto& powder : comparison.pilots) {
    std::printf("%s, ", powder.powder.c_str());
    print_pilot(powder.pilot);
  }
}

Json comparison_plan_as_json(const std::string& title, const plan::ComparisonForecast& comparison) {
  Json json = {{"title", title},
               {"wall_seconds", results::json_number(comparison.wall_seconds)},
               {"variants", Json::array()},
               {"pilots", Json::array()}};
  for (const auto& variant : comparison.variants) json["variants"].push_back(variant_as_json(variant));
  for (const auto& powder : comparison.pilots) {
    Json pilot = pilot_as_json(powder.pilot);
    pilot["powder"] = powder.powder;
    json["pilots"].push_back(pilot);
  }
  return json;
}

}  // namespace diefill::app
