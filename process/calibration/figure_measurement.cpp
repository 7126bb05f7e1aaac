// A figure of a scene, such as the mass through a slit: alone, or as a curve over a key of the scene, one run
// for each point.
#include <algorithm>
#include <cmath>
#include <limits>
#include <regex>

#include "process/calibration/measurement.h"
#include "process/calibration/possible_figures.h"
#include "process/calibration/scene_figures.h"
#include "process/input/nearest_key.h"
#include "process/input/scene_error.h"
#include "process/input/unit_conversion.h"
#include "process/results/figure_item.h"
#include "process/results/figure_table.h"
#include "process/results/formatted.h"
#include "process/scene/key_path.h"
#include "process/scene/scene_text.h"
#include "process/scene/variants.h"
#include "process/scene/zones.h"
#include "process/tradeoff/quantities.h"

namespace diefill::process::calibration {
namespace {

/// What a figure's name stands for.
struct ChosenFigure {
  std::string name, unit;
  std::function<double(const results::FillResult&)> value;
};

/// Figures of zones and heaps that the scene does not have, and of cavities that no die has. Results have
/// zones of the largest cavity alone, and heaps without a cavity.
void refuse_unknown_item(TableReader& table, const std::string& word,
                         const std::vector<std::string>& of_scene) {
  static const std::regex of_cavity("cavity_([0-9]+)_(.*)");
  std::smatch parts;
  const bool further = std::regex_match(word, parts, of_cavity);
  if (further && (parts[1].str().front() == '0' || parts[1] == "1"))
    table.reject("figure",
                 "further cavities have the numbers 2, 3 and so on; figures of the largest have none");
  const results::Figure* figure = results::find_figure(word);
  const std::string name = further ? parts[2].str() : word;
  if (figure == nullptr || !results::is_per_item(*figure) ||
      std::find(of_scene.begin(), of_scene.end(), word) != of_scene.end())
    return;
  std::vector<std::string> items;
  for (const std::string& key : of_scene)
    if (results::find_figure(key) == figure) items.push_back(key);
  const bool heap = std::string(figure->name).starts_with("slope_of_");
  if (further && std::find(items.begin(), items.end(), name) != items.end())
    table.reject("figure", std::string("of further cavities there are no figures of ") +
                               (heap ? "heaps" : "zones") + "; allowed: \"" + name + '"' +
                               (heap ? "" : ", of all cavities together"));
  if (items.empty())
    table.reject("figure", std::string("the scene has no [[measure.") + (heap ? "heap" : "zone") +
                               "]]; name one there, or choose another figure");
  throw SceneError(table.where("figure") + ": " + not_among(word, items));
}

/// Figures of flow probes that the scene does not have, and masses of a real powder whose density is not
/// known.
void refuse_unknown_flow(TableReader& table, const std::string& word, const Scene& scene) {
  static const std::regex of_flow("((real_mass|volume|mass|rate)_through_)(.*)");
  std::smatch parts;
  if (!std::regex_match(word, parts, of_flow)) return;
  std::vector<std::string> allowed;
  for (const ProbeSpec& probe : scene.probes)
    if (probe.quantity == ProbeQuantity::flow) allowed.push_back(parts[1].str() + probe.name);
  if (allowed.empty())
    table.reject("figure", "the scene has no [[probe]] with quantity = \"flow\"; add one with name = \"" +
                               parts[3].str() + '"');
  if (std::find(allowed.begin(), allowed.end(), word) == allowed.end())
    throw SceneError(table.where("figure") + ": " + not_among(word, allowed));
  if (parts[2] == "real_mass" && !(scene.powder.apparent_density > 0))
    table.reject("figure",
                 "the density of the real powder is not known; set powder.apparent_density, or measure "
                 "\"volume_through_" +
                     parts[3].str() + '"');
}

/// As results call the figure: of a further cavity some have another name after the number.
std::string stored_name(const std::string& word, const results::Figure& figure) {
  const std::string name = figure.name;
  const bool further = word.size() > name.size() && word.ends_with(name);
  return further && figure.other_name != nullptr
             ? word.substr(0, word.size() - name.size()) + figure.other_name
             : word;
}

/// A quantity of the trade-off, or else a figure of report.json.
ChosenFigure figure_called(TableReader& table, const std::string& word, const Scene& scene) {
  std::vector<std::string> known;
  for (const MeasuredQuantity& quantity : measured_quantities(scene)) {
    if (quantity.about.key == word) return {quantity.about.name, quantity.about.unit, quantity.value};
    known.push_back(quantity.about.key);
  }
  for (const Zone& zone : zones_in(scene.text)) known.push_back(zone_mass_figure(zone.name));
  refuse_unknown_flow(table, word, scene);
  refuse_unknown_item(table, word, known);
  for (const results::Figure& figure : results::figure_table()) known.emplace_back(figure.name);
  if (const results::Figure* figure = results::find_figure(word))
    return {results::label_of(*figure, results::item_of(*figure, word)), figure->unit,
            [name = stored_name(word, *figure)](const results::FillResult& result) {
              return results::figure_of(result, name);
            }};
  const auto meant = nearest_key(word, known);
  table.reject("figure", meant ? "no figure has this name; did you mean \"" + *meant + "\"?"
                               : "no figure has this name; process/results/figures.md and the keys of "
                                 "diefill tradeoff list them");
}

/// Throws SceneError unless `over` is the path of a key that a plant can vary and no parameter.
void check_over(const TableReader& table, const std::string& over, const MeasurementContext& context) {
  if (!is_key_path(over))
    table.reject("over",
                 "expected the path of a key alone, without \"=\", value or comment, such as "
                 "\"step.1.velocity\"");
  if (!can_be_varied(over))
    table.reject("over",
                 "allowed: a key that an experiment varies, such as \"step.1.velocity\"; this one belongs to "
                 "the file or the computation");
  refuse_parameters(table, "over", over + " = 0", context);
}

/// The factor that takes a figure into the data's unit.
double factor_into(const TableReader& table, const MeasuredColumn& column, const ChosenFigure& figure) {
  try {
    return unit_factor(figure.unit, column.unit);
  } catch (const UnitError& error) {
    throw SceneError(table.where("figure") + ": measured in \"" + column.unit + "\", but the figure has \"" +
                     figure.unit + "\": " + error.what());
  }
}

/// What a figure repeats after, in `unit`; 0 for figures that are no angles round a circle.
double period_of_figure(const std::string& word, const std::string& unit) {
  const results::Figure* figure = results::find_figure(word);
  if (figure == nullptr || !(figure->shown.period > 0)) return 0;
  return figure->shown.period * unit_factor(figure->shown.unit, unit);
}

/// Whether the measurement's file has the columns of a curve.
bool has_a_curve(TableReader& table) {
  try {
    return table.has("file") && read_measured(table, 1).size() > 0;
  } catch (const SceneError&) {
    return false;
  }
}

/// Values of a single figure. A table with a column of places needs `over`.
MeasuredTable measured_figure(TableReader& table) {
  try {
    return read_measured(table, 0);
  } catch (const SceneError&) {
    if (!has_a_curve(table)) throw;
    table.reject("file",
                 "which has a column of places besides value and deviation: name the key of the scene that "
                 "these are values of, such as over = \"step.1.velocity\"");
  }
}

/// An angle by whole periods as near to the measured one as it can be: 359 deg are -1 deg beside 2 deg.
double nearest_turn(double value, double measured, double period) {
  return period > 0 ? measured + std::remainder(value - measured, period) : value;
}

/// The line of TOML that sets the key to a place of a curve.
std::string assignment_at(double place, const std::string& key, const MeasuredColumn& column) {
  return assignment_line(key, results::formatted("%.10g", place), column.unit);
}

/// A run for each point of a curve: the scene with the key set.
std::vector<MeasurementRun> runs_over(const MeasurementRun& run, const std::string& key,
                                      const MeasuredColumn& column) {
  std::vector<MeasurementRun> runs;
  for (const double value : column.values) {
    MeasurementRun one = run;
    if (!one.set.empty() && one.set.back() != '\n') one.set += '\n';
    one.set += assignment_at(value, key, column);
    runs.push_back(std::move(one));
  }
  return runs;
}

/// Throws SceneError for a place of the curve that the scene cannot have, at its line where it stands in a
/// file; at `over` where the scene can have none of them.
void try_places(const MeasurementRun& run, const std::string& key, const MeasuredTable& data,
                const std::string& where_over) {
  const MeasuredColumn& places = data.places[0];
  std::optional<std::size_t> wrong;
  std::size_t failed = 0;
  for (std::size_t k = 0; k < data.size(); ++k) {
    try {
      try_assignment(run, assignment_at(places.values[k], key, places), where_over);
    } catch (const SceneError&) {
      if (!wrong) wrong = k;
      ++failed;
    }
  }
  if (!wrong) return;
  const bool is_of_file = !data.lines.empty() && failed < data.size();
  try_assignment(run, assignment_at(places.values[*wrong], key, places),
                 is_of_file ? data.where_of(*wrong) : where_over);
}

/// A value of each run, in the measured one's unit.
std::function<std::vector<double>(const std::vector<FinishedRun>&)> values_of_runs(
    const std::string& word, const ChosenFigure& figure, double factor, const MeasuredColumn& column) {
  return [factor, value = figure.value, measured = column.values,
          period = period_of_figure(word, column.unit)](const std::vector<FinishedRun>& runs) {
    std::vector<double> values;
    for (std::size_t k = 0; k < runs.size(); ++k)
      values.push_back(nearest_turn(factor * value(*runs[k].result), measured[k], period));
    return values;
  };
}

}  // namespace

Measurement read_figure_measurement(TableReader& table, const MeasurementContext& context) {
  const std::string word = table.required_text("figure", "expected_mass_kg");
  if (is_of_computation(word))
    table.reject("figure",
                 "this figure is of the computation, not of the powder; choose one that is measured");
  const auto over = table.text("over");
  if (over) check_over(table, *over, context);
  Measurement measurement;
  const MeasurementRun run = run_of_scene(table, context);
  measurement.data = over ? read_measured(table, 1) : measured_figure(table);
  if (!over && measurement.data.size() != 1)
    table.reject("file", "a single figure has one row; give \"over\" for a curve");
  const Scene scene = parse_scene(run.text, run.file);
  const ChosenFigure figure = figure_called(table, word, scene);
  if (const results::Figure* known = results::find_figure(word))
    if (const auto reason = why_powder_has_no(scene, known->name)) table.reject("figure", *reason);
  const double factor = factor_into(table, measurement.data.value, figure);
  refuse_impossible(measurement.data, possible_values_of_figure(word, figure.unit));
  measurement.quantity = figure.name;
  measurement.figure = word;
  measurement.figure_place = table.where("figure");
  if (over) try_places(run, *over, measurement.data, table.where("over"));
  measurement.runs = over ? runs_over(run, *over, measurement.data.places[0]) : std::vector{run};
  if (over) measurement.data.places[0].name = *over;
  measurement.simulated = values_of_runs(word, figure, factor, measurement.data.value);
  return measurement;
}

}  // namespace diefill::process::calibration
