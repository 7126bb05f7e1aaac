#include "app/tables/estimate_report.h"

#include <cstdio>
#include <nlohmann/json.hpp>
#include <set>

#include "process/results/json_numbers.h"

namespace diefill::app {

namespace {

using Json = nlohmann::ordered_json;
namespace estimate = process::estimate;

Json number(const std::optional<double>& value) {
  return value ? results::json_number(*value) : Json(nullptr);
}

Json opening_as_json(const estimate::OpeningEstimate& opening) {
  const bool cavity = opening.is_cavity;
  return {{"name", opening.name},
          {"is_cavity", cavity},
          {"centre_m", cavity ? Json({opening.centre.x(), opening.centre.y()}) : Json(nullptr)},
          {"volume_m3", cavity ? Json(opening.volume) : Json(nullptr)},
          {"depth_m", cavity ? Json(opening.depth) : Json(nullptr)},
          {"mouth_area_m2", opening.area},
          {"mean_width_m", opening.width},
          {"mean_width_as_felt_m", opening.effective_width},
          {"narrowest_width_m", cavity ? Json(opening.narrowest) : Json(nullptr)},
          {"full_mass_kg", cavity ? Json(opening.full_mass) : Json(nullptr)},
          {"offered_kg", results::json_numbers(opening.offered)},
          {"mass_kg", results::json_numbers(opening.mass)},
          {"mass_range_kg", {opening.least_mass, opening.most_mass}},
          {"share_filled", cavity ? Json(opening.share) : Json(nullptr)},
          {"share_filled_range", cavity ? Json({opening.least_share, opening.most_share}) : Json(nullptr)},
          {"share_filled_own_particles", number(opening.real_particle_share)},
          {"share_poured_over", opening.poured},
          {"share_of_mouth_without_flow", opening.too_fast},
          {"critical_speed_one_crossing_m_per_s", number(opening.speed_once)},
          {"critical_speed_m_per_s", number(opening.speed_all)},
          {"critical_speed_one_crossing_own_particles_m_per_s", number(opening.real_particle_speed_once)},
          {"fills_at_any_speed", opening.any_speed},
          {"crossings_needed", opening.crossings ? Json(*opening.crossings) : Json(nullptr)},
          {"froude", opening.froude},
          {"covered_s", opening.filling_time},
          {"air_escapes_s", number(opening.air_escapes)},
          {"air_trapped_share", opening.air_trapped},
          {"air_over_filling_time", opening.air_ratio}};
}

Json suction_as_json(const estimate::SuctionEstimate& suction) {
  return {{"tool", suction.punch.tool},
          {"stroke_m", suction.punch.stroke},
          {"speed_m_per_s", suction.punch.speed()},
          {"area_m2", suction.punch.area},
          {"room_kg", suction.volume_mass},
          {"share_of_room_below_powder", suction.covered},
          {"by_weight_kg", suction.by_weight},
          {"with_air_kg", number(suction.with_air)},
          {"pull_over_weight", number(suction.pull)},
          {"may_arch", suction.may_arch}};
}

Json outlet_as_json(const std::optional<estimate::OutletEstimate>& outlet) {
  if (!outlet) return nullptr;
  return {{"height_m", outlet->height},
          {"round", outlet->round},
          {"width_m", outlet->width},
          {"length_m", outlet->round ? Json(nullptr) : Json(outlet->length)},
          {"rate_kg_per_s", outlet->rate},
          {"mass_above_kg", outlet->mass},
          {"emptying_s", outlet->rate > 0 ? Json(outlet->mass / outlet->rate) : Json(nullptr)}};
}

Json powder_as_json(const estimate::Estimate& found) {
  const auto& powder = found.powder;
  const auto& law = found.law;
  return {{"apparent_density_kg_m3", powder.density},
          {"apparent_density_is_estimate", powder.density_is_estimate},
          {"grain_diameter_m", found.grain_diameter},
          {"bond", found.bond},
          {"in_shoe_kg", powder.in_shoe},
          {"let_in_kg", results::json_number(powder.let_in)},
          {"particle_diameter_m", number(powder.particle_diameter)},
          {"particle_diameter_source", powder.particle_source},
          {"archimedes_times_density_ratio", number(powder.air_number)},
          {"air_carrying_flux_m_per_s", number(powder.carrying_flux)},
          {"discharge_law",
           {{"C_B", law.numbers.burst},
            {"C_I", law.numbers.initial},
            {"C_F", law.numbers.steady},
            {"beta", law.numbers.beta},
            {"largest_x", results::json_number(law.longest)},
            {"largest_bond", results::json_number(law.largest_bond)},
            {"source", law.source},
            {"applies", law.applies},
            {"remark", law.remark}}}};
}

}  // namespace

const char* name_of(estimate::Answer answer) {
  switch (answer) {
    case estimate::Answer::nothing_moves:
      return "nothing to fill";
    case estimate::Answer::too_fast:
      return "too fast";
    case estimate::Answer::fills:
      return "fills";
    case estimate::Answer::no_formula:
      return "no estimate";
    case estimate::Answer::shut:
      return "nothing runs in";
    case estimate::Answer::open:
      break;
  }
  return "open";
}

void print_estimate(const estimate::Estimate& found) {
  std::set<std::string> printed;
  for (const auto& statement : estimate::statements(found)) {
    std::printf("%s: %s\n", statement.topic.c_str(), statement.words.c_str());
    std::string ground;
    const auto add = [&](const char* label, const std::string& text) {
      if (!text.empty()) ground += (ground.empty() ? "  " : "\n  ") + std::string(label) + text;
    };
    add("formula: ", statement.source);
    add("valid: ", statement.valid);
    add("error against DEM: ", statement.error);
    if (!ground.empty() && printed.insert(ground).second) std::printf("%s\n", ground.c_str());
  }
  for (const auto& number : found.numbers)
    std::printf("%s: %.3g, %s (%s)\n", number.name.c_str(), number.value, number.meaning.c_str(),
                number.source.c_str());
  if (found.is_estimated() && !found.law.remark.empty()) std::printf("note: %s\n", found.law.remark.c_str());
  std::printf("powder: apparent density %.3g g/cm3%s; %.3g g in the shoe\n", 1e-3 * found.powder.density,
              found.powder.density_is_estimate ? " (estimated; set powder.apparent_density)" : "",
              1e3 * found.powder.in_shoe);
}

Json estimate_as_json(const estimate::Estimate& found) {
  Json json = {{"answer", name_of(found.answer)},
               {"open_because", found.open_because},
               {"not_seen_from_above", found.unseen},
               {"inflow_error_factor", found.error.factor},
               {"packing_error", found.error.packing},
               {"error_is_measured", found.error.measured},
               {"error_source", found.error.source},
               {"powder", powder_as_json(found)},
               {"shoe",
                {{"tool", found.path.tool},
                 {"speed_m_per_s", found.path.speed},
                 {"dwell_s", found.path.standing},
                 {"length_m", found.path.length},
                 {"crossings", found.path.crossings}}},
               {"cycle_time_s", number(found.cycle_time)},
               {"openings", Json::array()},
               {"suction", Json::array()},
               {"outlet", outlet_as_json(found.outlet)},
               {"numbers", Json::array()},
               {"statements", Json::array()}};
  for (const auto& opening : found.openings) json["openings"].push_back(opening_as_json(opening));
  for (const auto& suction : found.suctions) json["suction"].push_back(suction_as_json(suction));
  for (const auto& one : found.numbers)
    json["numbers"].push_back(
        {{"name", one.name}, {"value", one.value}, {"meaning", one.meaning}, {"source", one.source}});
  for (const auto& one : estimate::statements(found))
    json["statements"].push_back({{"topic", one.topic},
                                  {"words", one.words},
                                  {"source", one.source},
                                  {"valid", one.valid},
                                  {"error_against_dem", one.error}});
  return json;
}

void print_estimate_in_short(const estimate::Estimate& found) {
  for (const auto& line : estimate::in_short(found)) std::printf("%s\n", line.c_str());
}

}  // namespace diefill::app
