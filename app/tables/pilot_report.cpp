#include "app/tables/pilot_report.h"

#include <cstdio>
#include <nlohmann/json.hpp>

namespace diefill::app {

using Json = nlohmann::ordered_json;
namespace plan = process::plan;

bool is_busy(const plan::Pilot& pilot) {
  constexpr double kFree = 0.95;
  return pilot.processor_share < kFree;
}

void print_pilot(const plan::Pilot& pilot) {
  if (!pilot.cached_since.empty())
    std::printf("pilot run: kept since %s; --new-pilot runs it again\n", pilot.cached_since.c_str());
  std::printf("processors: the machine gave the pilot %.0f %% of the processor time it asked for%s\n",
              100 * pilot.processor_share,
              is_busy(pilot) ? "; times on free processors exclude waiting, times on busy ones include it"
                             : ", about as much as on a free machine");
  std::printf("wall time: from a pilot run of %zu spheres, d = %.4g mm, %.4g mm of powder, %.1f s:",
              pilot.spheres, 1e3 * pilot.grain_diameter, 1e3 * pilot.fill_height, pilot.wall_seconds);
  for (int k = 0; k < plan::kPhaseKinds; ++k) {
    const auto& cost = pilot.cost[static_cast<std::size_t>(k)];
    if (cost.sphere_steps > 0)
      std::printf(" %s %.1f ns per sphere and step, %.0f %% of it for neighbour search%s;",
                  plan::description(static_cast<plan::PhaseKind>(k)), 1e9 * cost.seconds_per_sphere_step(),
                  100 * cost.search_seconds / cost.wall_seconds, cost.whole ? "" : " (incomplete)");
    else
      std::printf(" %s not reached, assumed to cost the same as settling;",
                  plan::description(static_cast<plan::PhaseKind>(k)));
  }
  std::printf(" excluding the time to read the tools\n");
  if (pilot.size.points.size() > 1) {
    std::printf("size: cost per sphere and step on this machine over that of the pilot run:");
    for (const auto& point : pilot.size.points)
      std::printf("%s %.2f (neighbour search %.2f) with %.0f spheres",
                  &point == &pilot.size.points.front() ? "" : ",",
                  pilot.size.factor(point.spheres, static_cast<double>(pilot.spheres)),
                  pilot.size.search_factor(point.spheres, static_cast<double>(pilot.spheres)), point.spheres);
    std::printf("\n");
  }
  if (!pilot.stopped.empty()) std::printf("note: the pilot run ended early: %s\n", pilot.stopped.c_str());
}

Json pilot_as_json(const plan::Pilot& pilot) {
  Json json = {{"grain_diameter_m", pilot.grain_diameter},
               {"fill_height_m", pilot.fill_height},
               {"spheres", pilot.spheres},
               {"wall_seconds", pilot.wall_seconds},
               {"processor_share", pilot.processor_share},
               {"kept_since", pilot.cached_since.empty() ? Json(nullptr) : Json(pilot.cached_since)},
               {"stopped", pilot.stopped},
               {"seconds_per_sphere_step", Json::object()}};
  for (int k = 0; k < plan::kPhaseKinds; ++k) {
    const auto& cost = pilot.cost[static_cast<std::size_t>(k)];
    if (cost.sphere_steps > 0)
      json["seconds_per_sphere_step"][plan::description(static_cast<plan::PhaseKind>(k))] =
          cost.seconds_per_sphere_step();
  }
  json["size_cost"] = Json::array();
  for (const auto& point : pilot.size.points)
    json["size_cost"].push_back({{"spheres", point.spheres},
                                 {"seconds_per_sphere_step", point.seconds_per_sphere_step},
                                 {"search_seconds_per_sphere", point.search_seconds}});
  return json;
}

}  // namespace diefill::app
