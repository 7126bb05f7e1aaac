#include "app/tables/tradeoff_table.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "app/tables/text_column.h"
#include "process/results/formatted.h"

namespace diefill::app {

namespace {

std::string number(double value, const char* format) {
  if (!std::isfinite(value)) return "-";
  return results::formatted(format, value);
}

std::string line(const std::string& name, std::size_t width, const std::string& core,
                 const std::string& per_second, const std::string& memory, const std::string& error,
                 const std::string& rest) {
  char numbers[200];
  std::snprintf(numbers, sizeof numbers, " %10s %12s %9s %9s  ", core.c_str(), per_second.c_str(),
                memory.c_str(), error.c_str());
  std::string whole = padded(name, width) + numbers + rest;
  whole.erase(whole.find_last_not_of(' ') + 1);
  return whole + '\n';
}

std::string marks(const results::Tradeoff& tradeoff, const results::TradeoffPoint& point) {
  std::string words = point.recommended ? "recommended" : point.pareto ? "Pareto-optimal" : "";
  if (point.reference) words += words.empty() ? "reference" : ", reference";
  for (const auto& quantity : tradeoff.quantities)
    if (std::ranges::find(point.beyond, quantity.key) != point.beyond.end())
      words += (words.empty() ? "error above limit: " : ", error above limit: ") + quantity.name;
  if (point.state != "finished") return point.state;
  if (!point.reason.empty()) words += words.empty() ? "failed with a seed" : ", failed with a seed";
  return words;
}

std::vector<const results::TradeoffPoint*> cheapest_first(const results::Tradeoff& tradeoff) {
  std::vector<const results::TradeoffPoint*> order;
  for (const auto& point : tradeoff.points) order.push_back(&point);
  std::stable_sort(order.begin(), order.end(), [](const auto* a, const auto* b) {
    if (std::isfinite(a->core_seconds) != std::isfinite(b->core_seconds))
      return std::isfinite(a->core_seconds);
    return a->core_seconds < b->core_seconds;
  });
  return order;
}

}  // namespace

std::string tradeoff_table(const results::Tradeoff& tradeoff) {
  constexpr double kMebibyte = 1024.0 * 1024.0;
  std::size_t width = 7;
  for (const auto& point : tradeoff.points)
    width = std::max(width, std::min(kWidestName, character_count(point.name)));
  std::string text =
      tradeoff.title + '\n' + line("setting", width, "core s", "core s per s", "MiB", "error %", "");
  for (const auto* point : cheapest_first(tradeoff))
    text += line(point->name, width, number(point->core_seconds, "%.3g"),
                 number(point->core_seconds_per_second, "%.3g"),
                 number(point->peak_memory_bytes / kMebibyte, "%.0f"), number(100 * point->error, "%.2g"),
                 marks(tradeoff, *point));
  if (std::isfinite(tradeoff.floor))
    text += "scatter over seeds up to " + number(100 * tradeoff.floor, "%.2g") + " %\n";
  text += tradeoff.advice + '\n';
  for (const auto& remark : tradeoff.remarks) text += "note: " + remark + '\n';
  return text;
}

}  // namespace diefill::app
