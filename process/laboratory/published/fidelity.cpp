#include "process/laboratory/published/fidelity.h"

#include <algorithm>
#include <cmath>
#include <fstream>

#include "process/laboratory/published/csv_fields.h"
#include "process/laboratory/published/lactose/powders_measured.h"
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

/// nullptr for families of experiments with a table of their own.
const SceneExperiment* scene_experiment(const std::string& name) {
  const auto& all = scene_experiments();
  const auto found = std::find_if(all.begin(), all.end(), [&](const auto& one) { return one.name == name; });
  return found == all.end() ? nullptr : &*found;
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
    line.verdict = "no experiment";
  } else if (measured.row == nullptr) {
    const bool by_scenes = scene_experiment(figure.experiment) != nullptr;
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

/// The figures of one section of a source.
struct Section {
  std::string title, rows;
  std::vector<std::string> experiments;  ///< that measure them
};

Section& section_of(const PublishedFigure& figure, std::vector<Section>& sections) {
  const std::string title = figure.source + ", " + figure.section;
  const auto found = std::find_if(sections.begin(), sections.end(),
                                  [&](const Section& section) { return section.title == title; });
  if (found != sections.end()) return *found;
  sections.push_back({title, {}, {}});
  return sections.back();
}

std::string text_of(const Section& section) {
  std::string text = "\n## " + section.title + "\n";
  for (const std::string& name : section.experiments) {
    const SceneExperiment* experiment = scene_experiment(name);
    text += "- `diefill lab " + name + (experiment == nullptr ? "`" : "`: " + experiment->question) + "\n";
  }
  return text + (section.experiments.empty() ? "" : "\n") +
         "| id | quantity | published (agrees) | here | verdict | d, mm | core s | note |\n"
         "|---|---|---|---|---|---|---|---|\n" +
         section.rows;
}

/// How many figures of each source have each verdict.
using Counts = std::map<std::string, std::map<std::string, int>>;

std::string counts_text(const std::vector<std::string>& sources, const Counts& counts) {
  std::string text = "| verdict |", line = "|---|";
  for (const std::string& source : sources) {
    text += " " + source + " |";
    line += "---|";
  }
  text += " all |\n" + line + "---|\n";
  for (const auto& [verdict, by_source] : counts) {
    int all = 0;
    text += "| " + (verdict == "-" ? std::string("in a table of its own") : verdict) + " |";
    for (const std::string& source : sources) {
      const auto found = by_source.find(source);
      const int count = found == by_source.end() ? 0 : found->second;
      text += " " + std::to_string(count) + " |";
      all += count;
    }
    text += " " + std::to_string(all) + " |\n";
  }
  return text;
}

template <class Value>
void add_once(const Value& value, std::vector<Value>& values) {
  if (std::find(values.begin(), values.end(), value) == values.end()) values.push_back(value);
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
  Counts counts;
  std::vector<std::string> sources;
  std::vector<Section> sections;
  for (const auto& figure : figures) {
    const Line line = line_of(figure, measured_in(tables, figure.id));
    ++counts[line.verdict][figure.source];
    add_once(figure.source, sources);
    Section& section = section_of(figure, sections);
    if (!figure.experiment.empty() && figure.kind != "input")
      add_once(figure.experiment, section.experiments);
    const auto remark = remarks.find(figure.id);
    section.rows += row_text(figure, line, remark == remarks.end() ? "" : remark->second);
  }
  std::string page =
      "# Fidelity\n\n"
      "Written by `diefill lab fidelity` from `kept_results.csv` and\n"
      "`sample_tools/laboratory/comparisons.csv`; do not edit. One row for every published figure, by "
      "section\n"
      "of its source. Here: mean +- standard deviation over seeds. d: the coarsest grains of its runs. Core "
      "s:\n"
      "processor time of these runs, which other rows may share. The published sizes are finer: a verdict\n"
      "holds for the size in the note.\n\n" +
      counts_text(sources, counts);
  for (const Section& section : sections) page += text_of(section);
  return page + powders_measured(figures, [&](const PublishedFigure& figure) {
           const Line line = line_of(figure, measured_in(tables, figure.id));
           return line.here + " (" + line.verdict + ")";
         });
}

}  // namespace diefill::process::laboratory
