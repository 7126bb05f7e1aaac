#include "process/continuum/discharge_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "process/input/csv_file.h"
#include "process/input/nearest_key.h"
#include "process/input/scene_error.h"
#include "process/input/shown_value.h"
#include "process/input/units.h"

namespace diefill::process::continuum {

namespace {

constexpr std::size_t kMaxPoints = 200000;

/// A quantity that a column may hold.
struct Quantity {
  const char* name;
  Dimension dimension;
  bool may_be_zero;
  double most = std::numeric_limits<double>::infinity();  ///< SI units
};

constexpr double kDensest = 25e3;  // kg/m^3, above osmium
constexpr double kLongest = 1e3;   // m

constexpr std::array<Quantity, 11> kQuantities = {{{"speed", Dimension::velocity, false},
                                                   {"time", Dimension::time, true},
                                                   {"mass", Dimension::mass, true},
                                                   {"rate", Dimension::mass_rate, true},
                                                   {"error", Dimension::mass, false},
                                                   {"rate_error", Dimension::mass_rate, false},
                                                   {"width", Dimension::length, false, kLongest},
                                                   {"diameter", Dimension::length, false, kLongest},
                                                   {"length", Dimension::length, false, kLongest},
                                                   {"shoe_length", Dimension::length, false, kLongest},
                                                   {"density", Dimension::density, false, kDensest}}};

struct Column {
  const Quantity* quantity = nullptr;
  std::string unit;
};

CsvFile opened(const std::filesystem::path& file) {
  constexpr std::size_t kLargest = 32U << 20U;
  try {
    CsvFile table(
        file, {"table of discharges", "but a table of discharges is a CSV file of measurements", kLargest});
    if (table.next()) return table;
  } catch (const SceneError&) {
    throw;
  } catch (const std::runtime_error& reason) {
    throw SceneError(file.string() + ": " + reason.what());
  }
  throw SceneError(file.string() +
                   ": found no lines; give a heading such as \"speed m/s,mass g\" and a line for each "
                   "measurement");
}

std::string allowed_columns() {
  std::string names;
  for (const auto& quantity : kQuantities) names += (names.empty() ? "" : ", ") + std::string(quantity.name);
  return names;
}

Column column_of(std::string heading, const std::string& place) {
  constexpr std::string_view kProbesRate = "mass rate";  // as a flow probe calls it
  if (heading.starts_with(kProbesRate)) heading.replace(0, kProbesRate.size(), "rate");
  const auto [name, unit] = csv_heading(heading);
  const auto found =
      std::find_if(kQuantities.begin(), kQuantities.end(),
                   [&, &called = name](const auto& quantity) { return called == quantity.name; });
  if (found == kQuantities.end()) {
    std::vector<std::string> known;
    for (const auto& quantity : kQuantities) known.emplace_back(quantity.name);
    const auto nearest = nearest_key(name, known);
    throw SceneError(place + ": found column \"" + one_line(heading) + "\"" +
                     (nearest ? "; did you mean \"" + *nearest + "\"?" : "") +
                     " (allowed: " + allowed_columns() + ", each with its unit, such as \"mass g\")");
  }
  const Dimension dimension = found->dimension;
  if (unit.empty())
    throw SceneError(place + ": found column \"" + one_line(heading) + "\" without a unit; write it after " +
                     "the name, such as \"" + name + " " +
                     std::string(example_of(dimension)).substr(example_of(dimension).find(' ') + 1) + "\"");
  try {
    parse_quantity("1 " + unit, dimension);
  } catch (const UnitError& error) {
    throw SceneError(place + ": column " + name + ": found unit \"" + one_line(unit) + "\", " + error.what());
  }
  return {&*found, unit};
}

std::vector<Column> columns_of(const CsvFile& file) {
  std::vector<Column> columns;
  std::vector<std::string> names;
  for (std::size_t k = 0; k < file.cells().size(); ++k) {
    columns.push_back(column_of(file.cells()[k], file.place(k)));
    const std::string name = columns.back().quantity->name;
    names.push_back(name == "width" || name == "diameter" ? "width or diameter" : name);
  }
  file.refuse_twice(names);
  return columns;
}

bool has(const std::vector<Column>& columns, const std::string& name) {
  return std::any_of(columns.begin(), columns.end(),
                     [&](const Column& column) { return name == column.quantity->name; });
}

double value_of(const CsvFile& file, std::size_t k, const Column& column) {
  const std::string& cell = file.cells()[k];
  file.number(k, column.quantity->name);
  const std::string where = file.place(k) + ": column " + column.quantity->name + ": found ";
  double value = 0;
  try {
    value = parse_quantity(cell + ' ' + column.unit, column.quantity->dimension);
  } catch (const UnitError& error) {
    throw SceneError(where + "\"" + one_line(cell) + "\", " + error.what());
  }
  if (value < 0 || (value == 0 && !column.quantity->may_be_zero))
    throw SceneError(where + one_line(cell) +
                     (column.quantity->may_be_zero ? ", allowed: 0 or more" : ", allowed: above 0"));
  if (value > column.quantity->most)
    throw SceneError(where + one_line(cell) + ' ' + column.unit + ", allowed: at most " +
                     number_text(column.quantity->most) +
                     (column.quantity->dimension == Dimension::density ? " kg/m^3" : " m"));
  return value;
}

void set(const std::string& name, double value, bool rates, DischargePoint& point, double& density) {
  if (name == "speed") point.speed = value;
  if (name == "time") point.time = value;
  if (name == (rates ? "rate" : "mass")) point.value = value;
  if (name == (rates ? "rate_error" : "error")) point.error = value;
  if (name == "width" || name == "diameter") point.width = value;
  if (name == "length") point.length = value;
  if (name == "shoe_length") point.shoe_length = value;
  if (name == "density") density = value;
}

/// What a law needs, and how the command line gives it; an empty option: only as a column.
struct Need {
  std::string column, option;
  bool given;
};

void refuse_missing(const std::vector<Column>& columns, const std::string& place, DischargeLaw law,
                    const CommonToAll& common) {
  std::vector<Need> needs = {{is_of_rates(law) ? "rate" : "mass", "", false}};
  if (law == DischargeLaw::beverloo_round)
    needs.push_back({"diameter", "", false});
  else
    needs.push_back({"width", "--width", common.width.has_value()});
  needs.push_back({"density", "--density", common.density.has_value()});
  if (is_of_shoe(law)) needs.push_back({"speed", "", false});
  if (law == DischargeLaw::transient) needs.push_back({"time", "", false});
  if (law != DischargeLaw::beverloo_round) needs.push_back({"length", "--length", common.length.has_value()});
  if (is_of_shoe(law)) needs.push_back({"shoe_length", "--shoe-length", common.shoe_length.has_value()});
  for (const Need& need : needs)
    if (!need.given && !has(columns, need.column))
      throw SceneError(place + ": law " + name_of(law) + " needs " + need.column + ": add a column" +
                       (need.option.empty() ? "" : ", or give " + need.option));
}

/// Columns that a law has a use for.
std::vector<std::string> columns_for(DischargeLaw law) {
  if (law == DischargeLaw::beverloo_round) return {"rate", "diameter", "rate_error", "density"};
  if (law == DischargeLaw::beverloo_slit) return {"rate", "width", "length", "rate_error", "density"};
  if (law == DischargeLaw::transient)
    return {"time", "mass", "width", "length", "error", "density", "rate"};  // a flow probe's file has rates
  return {"speed", "mass", "width", "length", "shoe_length", "error", "density"};
}

bool takes(DischargeLaw law, const std::string& column) {
  const auto taken = columns_for(law);
  return std::find(taken.begin(), taken.end(), column) != taken.end();
}

void refuse_unused_columns(const std::vector<Column>& columns, const std::string& place, DischargeLaw law) {
  std::string taken;
  for (const std::string& name : columns_for(law)) taken += (taken.empty() ? "" : ", ") + name;
  for (const Column& column : columns)
    if (!takes(law, column.quantity->name))
      throw SceneError(place + ": found column " + column.quantity->name + ", which law " + name_of(law) +
                       " does not take (allowed: " + taken + "); remove it, or choose another --law");
}

void refuse_unused_options(const std::vector<Column>& columns, const std::string& place, DischargeLaw law,
                           const CommonToAll& common) {
  const std::vector<Need> options = {{"width", "--width", common.width.has_value()},
                                     {"length", "--length", common.length.has_value()},
                                     {"shoe_length", "--shoe-length", common.shoe_length.has_value()},
                                     {"density", "--density", common.density.has_value()}};
  for (const Need& option : options) {
    if (!option.given) continue;
    if (!takes(law, option.column))
      throw SceneError(option.option + ": law " + name_of(law) + " has no " + option.column +
                       "; leave it out, or choose another --law");
    if (has(columns, option.column))
      throw SceneError(option.option + ": " + place + " has a column " + option.column +
                       " as well; leave one of them out");
  }
}

/// The measurement of the line, and its density where it has one.
DischargePoint point_of(const CsvFile& file, const std::vector<Column>& columns, DischargeLaw law,
                        const CommonToAll& common, double& density) {
  DischargePoint point;
  point.width = common.width.value_or(0);
  point.length = common.length.value_or(0);
  point.shoe_length = common.shoe_length.value_or(0);
  for (std::size_t k = 0; k < columns.size(); ++k)
    set(columns[k].quantity->name, value_of(file, k, columns[k]), is_of_rates(law), point, density);
  if (point.value == 0 && point.error == 0 && law != DischargeLaw::transient)
    throw SceneError(
        file.place() + ": found " + (is_of_rates(law) ? "a rate" : "a mass") +
        " of 0, allowed: above 0, because points without errors are weighted relative to their values; "
        "remove the line, or add a column of errors");
  return point;
}

/// Leaves out what was recorded after common.until.
void leave_out_later(const CommonToAll& common, DischargeLaw law, const std::filesystem::path& file,
                     DischargeData& data) {
  if (!common.until) return;
  const std::string found = "--until: found " + number_text(*common.until) + " s, ";
  if (law != DischargeLaw::transient)
    throw SceneError(found + "but law " + name_of(law) + " has no times; --until is only for law transient");
  if (common.opened && *common.until <= *common.opened)
    throw SceneError(found + "allowed: after --opened, " + number_text(*common.opened) + " s");
  std::erase_if(data.points, [&](const auto& point) { return point.time > *common.until; });
  if (data.points.empty())
    throw SceneError(found + "but " + file.string() + " has no time up to then; check the time and its unit");
}

/// Takes time and mass as those since common.opened.
void count_from_opening(const CommonToAll& common, DischargeLaw law, const std::filesystem::path& file,
                        DischargeData& data) {
  if (!common.opened) return;
  const double opened = *common.opened;
  if (law != DischargeLaw::transient)
    throw SceneError("--opened: found " + number_text(opened) + " s, but law " + name_of(law) +
                     " has no times; --opened is only for law transient");
  const bool none = std::none_of(data.points.begin(), data.points.end(),
                                 [&](const auto& point) { return point.time >= opened; });
  if (none)
    throw SceneError("--opened: found " + number_text(opened) + " s, but " + file.string() +
                     " has no time from then on" + (common.until ? " up to --until" : "") +
                     "; check the time and its unit");
  double before = 0;
  for (const auto& point : data.points)
    if (point.time <= opened) before = std::max(before, point.value);
  std::erase_if(data.points, [&](const auto& point) { return point.time < opened; });
  for (auto& point : data.points) {
    point.time -= opened;
    point.value -= before;
  }
}

/// Laws are linear in the density: points with a density of their own are scaled to the lowest.
void scale_to_one_density(const std::vector<double>& densities, DischargeData& data) {
  if (densities.empty()) return;
  data.density = *std::min_element(densities.begin(), densities.end());
  for (std::size_t k = 0; k < densities.size(); ++k) {
    data.points[k].value *= data.density / densities[k];
    data.points[k].error *= data.density / densities[k];
  }
}

}  // namespace

DischargeLaw law_for_table(const std::filesystem::path& file) {
  const CsvFile heading = opened(file);
  const auto columns = columns_of(heading);
  if (has(columns, "mass") && has(columns, "speed")) return DischargeLaw::moving_shoe;
  if (has(columns, "mass") && has(columns, "time")) return DischargeLaw::transient;
  if (has(columns, "rate") && has(columns, "diameter")) return DischargeLaw::beverloo_round;
  if (has(columns, "rate") && has(columns, "width")) return DischargeLaw::beverloo_slit;
  throw SceneError(heading.place() +
                   ": no law fits these columns; give mass and speed, mass and time, or rate "
                   "and diameter or width");
}

DischargeData read_discharge_table(const std::filesystem::path& path, DischargeLaw law,
                                   const CommonToAll& common) {
  CsvFile file = opened(path);
  const auto columns = columns_of(file);
  refuse_missing(columns, file.place(), law, common);
  refuse_unused_columns(columns, file.place(), law);
  refuse_unused_options(columns, file.place(), law, common);
  DischargeData data;
  data.density = common.density.value_or(0);
  data.grain_diameter = common.grain_diameter.value_or(0);
  std::vector<double> densities;
  while (file.next()) {
    double density = data.density;
    data.points.push_back(point_of(file, columns, law, common, density));
    densities.push_back(density);
    if (data.points.size() > kMaxPoints)
      throw SceneError(file.place() + ": found more than " + std::to_string(kMaxPoints) +
                       " measurements; leave out some");
  }
  scale_to_one_density(densities, data);
  leave_out_later(common, law, path, data);
  count_from_opening(common, law, path, data);
  return data;
}

}  // namespace diefill::process::continuum
