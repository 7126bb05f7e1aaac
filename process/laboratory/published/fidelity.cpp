#include "process/laboratory/published/fidelity.h"

#include <algorithm>
#include <cmath>
#include <fstream>

#include "process/laboratory/published/csv_fields.h"
#include "process/laboratory/published/scene_experiment.h"
#include "process/results/formatted.h"
#include "process/results/rounding.h"

namespace diefill::process::laboratory {
namespace {

/// A figure's line of the page.
struct Line {
  std::string here = "-", verdict, diameter = "-", seconds = "-", note;
};

std::string in_cell(std::string text) {
  std::string cell;
  for (const char letter : text) cell += letter == '|' ? std::string("/") : std::string(1, letter);
  return cell;
}

std::string digits(double value, const char* format) {
  return results::formatted(format, value);
}

struct Measured {
  const results::LabRow* row = nullptr;
  const results::LabTable* table = nullptr;
};

/// The finest value there is, or else a row that says why there is none.
Measured measured_in(const std::vector<results::LabTable>& tables, const std::string& id) {
  Measured found;
  for (const auto& table : tables)
    for (const auto& row : table.rows)
      if (row.id == id && (found.row == nullptr || !row.values.empty())) found = {&row, &table};
  return found;
}

bool is_scene_experiment(const std::string& name) {
  const auto& all = scene_experiments();
  return std::any_of(all.begin(), all.end(), [&](const auto& one) { return one.name == name; });
}

/// Why there is no value. Of a run that stops the page names the run; what it says, with places and times, is
/// in the table of kept results, and the cause in a remark.
std::string reason_text(const std::string& reason) {
  const std::size_t failure = reason.find("\" failed: ");
  if (failure == std::string::npos) return reason;
  return reason.substr(0, failure + 1) + " stops before its end (message in kept_results.csv)";
}

/// Size and seeds, how the value was had, and what was measured where that is not the published quantity
/// itself, such as the deviation of spheres other than the source's.
std::string note_of(const PublishedFigure& figure, const Measured& measured) {
  const results::LabRow& row = *measured.row;
  if (row.values.empty()) return reason_text(row.reason);
  const bool calculated =
      row.values.size() == 1 && row.core_seconds == 0 && !std::isfinite(row.grain_diameter);
  if (calculated) return "calculated, without a bed";
  const std::size_t seeds = results::seeds_of(row);
  std::string note = measured.table->size + ", " + std::to_string(seeds) + (seeds > 1 ? " seeds" : " seed");
  if (!row.quantity.empty() && row.quantity != figure.quantity) note += "; " + row.quantity;
  return note + (row.reason.empty() ? "" : "; " + row.reason);
}

Line line_of(const PublishedFigure& figure, const Measured& measured) {
  Line line;
  if (figure.kind == "input") {
    line.verdict = "input";
  } else if (figure.experiment.empty()) {
    line.verdict = "not built";
  } else if (measured.row == nullptr) {
    const bool by_scenes = is_scene_experiment(figure.experiment);
    line.verdict = by_scenes ? "not run" : "-";
    if (!by_scenes) line.note = "table of its own: `diefill lab " + figure.experiment + "`";
  } else {
    line.here = results::here_text(*measured.row);
    line.verdict = measured.row->verdict;
    line.note = note_of(figure, measured);
    if (std::isfinite(measured.row->grain_diameter))
      line.diameter = digits(1e3 * measured.row->grain_diameter, "%.3g");
    line.seconds = digits(measured.row->core_seconds, "%.0f");
  }
  return line;
}

std::string row_text(const PublishedFigure& figure, const Line& line, const std::string& remark) {
  results::LabRow limits;
  limits.published = figure.published;
  limits.lower = figure.lower;
  limits.upper = figure.upper;
  std::string what = figure.quantity;
  const std::string setting = figure.model.empty()
                                  ? figure.setting
                                  : figure.model + (figure.setting.empty() ? "" : "; " + figure.setting);
  if (!setting.empty()) what += " (" + setting + ")";
  std::string note = line.note;
  if (!remark.empty()) note += (note.empty() ? "" : ". ") + remark;
  const std::string unit = results::unit_behind(figure.unit);
  return "| " + figure.id + " | " + in_cell(what) + " | " + in_cell(results::published_text(limits)) + unit +
         " | " + line.here + " | " + line.verdict + " | " + line.diameter + " | " + line.seconds + " | " +
         in_cell(note) + " |\n";
}

std::string counts_text(const std::map<std::string, int>& counts) {
  std::string text;
  for (const auto& [verdict, count] : counts)
    text += "| " + (verdict == "-" ? std::string("in a table of its own") : verdict) + " | " +
            std::to_string(count) + " |\n";
  return text;
}

}  // namespace

std::map<std::string, std::string> read_remarks(const std::filesystem::path& file) {
  std::map<std::string, std::string> remarks;
  std::ifstream stream(file);
  std::string text;
  std::getline(stream, text);
  while (std::getline(stream, text)) {
    const auto fields = csv_fields(text);
    if (fields.size() == 2) remarks[fields[0]] = fields[1];
  }
  return remarks;
}

std::string fidelity_page(const std::vector<PublishedFigure>& figures,
                          const std::vector<results::LabTable>& tables,
                          const std::map<std::string, std::string>& remarks) {
  const std::string head =
      "| id | quantity | published (agrees) | here | verdict | d, mm | core s | note |\n"
      "|---|---|---|---|---|---|---|---|\n";
  std::map<std::string, int> counts;
  std::string rows, section;
  for (const auto& figure : figures) {
    const Line line = line_of(figure, measured_in(tables, figure.id));
    ++counts[line.verdict];
    if (figure.source + figure.section != section) {
      section = figure.source + figure.section;
      rows += "\n## " + figure.source + ", " + figure.section + "\n" + head;
    }
    const auto remark = remarks.find(figure.id);
    rows += row_text(figure, line, remark == remarks.end() ? "" : remark->second);
  }
  return "# Fidelity\n\nWritten by `diefill lab fidelity` from `kept_results.csv` and "
         "`sample_tools/laboratory/comparisons.csv`; do not edit. One row for "
         "every "
         "published figure.\nHere: mean +- standard deviation over seeds. d: the coarsest grains of its "
         "runs. "
         "Core s: processor time of these runs, which\nother rows may share. The published sizes are finer: "
         "a "
         "verdict holds for the size in the note.\n\n"
         "| verdict | figures |\n|---|---|\n" +
         counts_text(counts) + rows;
}

}  // namespace diefill::process::laboratory
