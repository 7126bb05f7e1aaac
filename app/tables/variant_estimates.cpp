#include "app/tables/variant_estimates.h"

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "app/tables/estimate_report.h"
#include "app/tables/text_column.h"
#include "process/estimate/statements/wording.h"
#include "process/results/formatted.h"
#include "process/results/json_numbers.h"

namespace diefill::app {

namespace {

namespace estimate = process::estimate;

/// The least filled cavity, which decides the estimate's answer; null where the shoe fills none.
const estimate::OpeningEstimate* emptiest_cavity(const estimate::Estimate& found) {
  const estimate::OpeningEstimate* worst = nullptr;
  for (const auto& opening : found.openings)
    if (opening.is_cavity && !opening.offered.empty() && (worst == nullptr || opening.share < worst->share))
      worst = &opening;
  return worst;
}

std::string filled_percent(double share) {
  return results::formatted("%.0f", estimate::percent_up_to_full(share));
}

std::string number_or_dash(const std::optional<double>& value) {
  char text[40] = "-";
  if (value) std::snprintf(text, sizeof text, "%.2g", *value);
  return text;
}

std::optional<double> speed_of(const estimate::Estimate& found) {
  if (found.path.speed > 0) return found.path.speed;
  return std::nullopt;
}

void print_line(const VariantEstimate& variant, std::size_t width) {
  const estimate::Estimate& found = variant.estimate;
  const estimate::OpeningEstimate* cavity = emptiest_cavity(found);
  std::string filled = "-", range = "-", critical = "-", needed = "-";
  if (cavity != nullptr) {
    filled = filled_percent(cavity->share);
    range = filled_percent(cavity->least_share) + " to " + filled_percent(cavity->most_share);
    critical = cavity->any_speed ? "any" : number_or_dash(cavity->speed_all);
    if (cavity->crossings) needed = std::to_string(*cavity->crossings);
  }
  std::printf("%s%11s%13s%12s%15s%11zu%8s%15s  %s\n", padded(variant.name, width).c_str(), filled.c_str(),
              range.c_str(), number_or_dash(speed_of(found)).c_str(), critical.c_str(), found.path.crossings,
              needed.c_str(), number_or_dash(found.cycle_time).c_str(), name_of(found.answer));
}

}  // namespace

void print_variant_estimates(const std::vector<VariantEstimate>& variants) {
  std::size_t width = 8;
  for (const auto& variant : variants)
    width = std::max(width, std::min(kWidestName, character_count(variant.name)));
  std::printf("%s%11s%13s%12s%15s%11s%8s%15s  %s\n", padded("variant", width).c_str(), "filled, %",
              "range, %", "speed, m/s", "critical, m/s", "crossings", "needed", "cycle time, s", "answer");
  for (const auto& variant : variants) print_line(variant, width);
  std::printf(
      "filled: share of the emptiest cavity by formula, with its range; critical: highest shoe speed that "
      "fills it in the variant's crossings; needed: crossings that fill it at its speed; -: not known, or "
      "no cavity\n");
}

nlohmann::ordered_json estimate_in_short_as_json(const estimate::Estimate& found) {
  const estimate::OpeningEstimate* cavity = emptiest_cavity(found);
  nlohmann::ordered_json json = {{"answer", name_of(found.answer)},
                                 {"share_filled", nullptr},
                                 {"share_filled_range", nullptr},
                                 {"shoe_speed_m_per_s", results::json_number(speed_of(found))},
                                 {"critical_speed_m_per_s", nullptr},
                                 {"critical_speed_one_crossing_m_per_s", nullptr},
                                 {"crossings", found.path.crossings},
                                 {"crossings_needed", nullptr},
                                 {"cycle_time_s", results::json_number(found.cycle_time)}};
  if (cavity == nullptr) return json;
  json["share_filled"] = cavity->share;
  json["share_filled_range"] = {cavity->least_share, cavity->most_share};
  json["critical_speed_m_per_s"] = results::json_number(cavity->speed_all);
  json["critical_speed_one_crossing_m_per_s"] = results::json_number(cavity->speed_once);
  if (cavity->crossings) json["crossings_needed"] = *cavity->crossings;
  return json;
}

nlohmann::ordered_json variant_estimates_as_json(const std::vector<VariantEstimate>& variants) {
  auto lines = nlohmann::ordered_json::array();
  for (const auto& variant : variants) {
    nlohmann::ordered_json line = {{"name", variant.name}};
    line.update(estimate_in_short_as_json(variant.estimate));
    lines.push_back(line);
  }
  return lines;
}

}  // namespace diefill::app
