#include "app/tables/lab_table_text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "app/tables/text_column.h"
#include "process/results/formatted.h"
#include "process/results/rounding.h"

namespace diefill::app {

namespace {

using Cells = std::array<std::string, 8>;

std::string digits(double value, const char* format) {
  if (!std::isfinite(value)) return "-";
  return results::formatted(format, value);
}

Cells cells_of(const results::LabRow& row) {
  constexpr std::size_t kWidest = 56;
  std::string quantity = row.quantity + (row.setting.empty() ? "" : " (" + row.setting + ")");
  if (row.quantity.find("over the measured") != std::string::npos) quantity += " " + row.id;
  if (quantity.size() > kWidest) quantity = quantity.substr(0, kWidest - 3) + "...";
  return {row.id.size() > 8 ? "" : row.id,
          quantity,
          results::published_text(row),
          results::here_text(row) + results::unit_behind(row.unit),
          row.verdict,
          std::to_string(results::seeds_of(row)),
          digits(1e3 * row.grain_diameter, "%.3g"),
          digits(row.core_seconds, "%.0f")};
}

}  // namespace

std::string lab_table_text(const results::LabTable& table) {
  std::vector<Cells> lines = {
      {"", "quantity", "published (agrees)", "here", "verdict", "seeds", "d, mm", "core s"}};
  for (const auto& row : table.rows) lines.push_back(cells_of(row));
  std::array<std::size_t, 8> width = {};
  for (const Cells& line : lines)
    for (std::size_t k = 0; k < line.size(); ++k) width[k] = std::max(width[k], line[k].size());
  std::string text = table.experiment + ": " + table.question + "\n";
  for (const Cells& line : lines) {
    for (std::size_t k = 0; k < line.size(); ++k) text += (k == 0 ? "" : "  ") + padded(line[k], width[k]);
    text.erase(text.find_last_not_of(' ') + 1);
    text += '\n';
  }
  for (const auto& row : table.rows)
    if (!row.reason.empty()) text += "note: " + row.id + ": " + row.reason + '\n';
  return text + digits(table.core_seconds, "%.0f") + " s of processor time in all\n";
}

}  // namespace diefill::app
