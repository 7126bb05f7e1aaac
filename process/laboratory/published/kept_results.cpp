#include "process/laboratory/published/kept_results.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "process/input/scene_error.h"
#include "process/laboratory/published/csv_rows.h"
#include "process/laboratory/published/perform.h"
#include "process/results/csv_field.h"

namespace diefill::process::laboratory {
namespace {

constexpr std::size_t kColumns = 7, kOptional = 1;  // the seeds, where each has a value
const std::array<std::string, 3> kSizes = {"coarse", "medium", "published"};

KeptResult result_of(const std::vector<std::string>& fields, const PublishedFigure& figure,
                     const std::string& where) {
  KeptResult kept;
  kept.size = fields[1];
  fineness_of(kept.size, where);
  kept.row.id = figure.id;
  take_published(figure, kept.row);
  kept.row.values = numbers_in(fields[2], where);
  if (!fields[3].empty()) kept.row.grain_diameter = 1e-3 * number_in(fields[3], where);
  kept.row.core_seconds = number_in(fields[4], where);
  kept.row.reason = fields[5];
  if (fields.size() == kColumns) kept.row.seeds = static_cast<std::size_t>(number_in(fields[6], where));
  kept.row.verdict = verdict_of(kept.row);
  return kept;
}

auto find_in(std::vector<KeptResult>& kept, const std::string& id) {
  return std::find_if(kept.begin(), kept.end(), [&](const KeptResult& one) { return one.row.id == id; });
}

bool is_kept(const std::vector<KeptResult>& kept, const std::string& id) {
  return std::any_of(kept.begin(), kept.end(), [&](const KeptResult& one) { return one.row.id == id; });
}

/// What the experiment calls the quantity, which the file of kept results does not hold: that of its present
/// table of the same size, whether it has a value there or not.
std::string quantity_in(const std::vector<results::LabTable>& measured, const KeptResult& kept) {
  for (const auto& table : measured) {
    if (table.size != kept.size) continue;
    for (const auto& row : table.rows)
      if (row.id == kept.row.id && !row.quantity.empty()) return row.quantity;
  }
  return kept.row.quantity;
}

}  // namespace

std::size_t fineness_of(const std::string& size, const std::string& where) {
  const auto found = std::find(kSizes.begin(), kSizes.end(), size);
  if (found == kSizes.end())
    throw SceneError(where + ": found \"" + size + "\", expected coarse, medium or published");
  return static_cast<std::size_t>(found - kSizes.begin());
}

bool replaces(const results::LabRow& row, const std::string& size, const results::LabRow& earlier,
              const std::string& earlier_size) {
  if (row.values.empty() || earlier.values.empty()) return earlier.values.empty();
  if (size == earlier_size) return results::seeds_of(row) >= results::seeds_of(earlier);
  return fineness_of(size) > fineness_of(earlier_size);
}

std::vector<KeptResult> read_kept_results(const std::filesystem::path& file,
                                          const std::vector<PublishedFigure>& figures) {
  std::vector<KeptResult> kept;
  const auto take = [&](const std::vector<std::string>& fields, const std::string& where) {
    const auto figure = std::find_if(figures.begin(), figures.end(),
                                     [&](const PublishedFigure& one) { return one.id == fields[0]; });
    if (figure != figures.end()) kept.push_back(result_of(fields, *figure, where));
  };
  for_each_row(file, kColumns, MissingFile::no_rows, take, kOptional);
  return kept;
}

void take_over(std::vector<KeptResult>& kept, const std::vector<results::LabTable>& measured) {
  for (const auto& table : measured)
    for (const auto& row : table.rows) {
      if (row.published.empty() || !(row.core_seconds > 0)) continue;
      const auto earlier = find_in(kept, row.id);
      if (earlier == kept.end())
        kept.push_back({table.size, row});
      else if (replaces(row, table.size, earlier->row, earlier->size))
        *earlier = {table.size, row};
    }
}

std::string csv_of(const std::vector<KeptResult>& kept) {
  std::string text = "id,size,values,d_mm,core_seconds,reason,seeds\n";
  for (const auto& [size, row] : kept) {
    text += row.id + ',' + size + ',' + text_of(row.values) + ',' +
            results::csv_number(1e3 * row.grain_diameter, 6) + ',' +
            results::csv_number(row.core_seconds, 4) + ',' + results::csv_text(row.reason) + ',' +
            std::to_string(results::seeds_of(row)) + '\n';
  }
  return text;
}

std::vector<results::LabTable> tables_with_kept(const std::vector<KeptResult>& kept,
                                                std::vector<results::LabTable> measured) {
  std::vector<results::LabTable> tables;
  for (const std::string& size : kSizes) {
    results::LabTable table;
    table.size = size;
    for (const auto& one : kept) {
      if (one.size != size) continue;
      table.rows.push_back(one.row);
      table.rows.back().quantity = quantity_in(measured, one);
    }
    tables.push_back(std::move(table));
  }
  for (auto& table : measured) {
    std::erase_if(table.rows, [&](const results::LabRow& row) { return is_kept(kept, row.id); });
    tables.push_back(std::move(table));
  }
  return tables;
}

}  // namespace diefill::process::laboratory
