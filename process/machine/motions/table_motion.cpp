#include "process/machine/motions/table_motion.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "process/input/csv_file.h"
#include "process/input/numbers_apart.h"
#include "process/input/scene_error.h"
#include "process/input/shown_value.h"
#include "process/machine/motion_limits.h"
#include "process/machine/moving_tool.h"
#include "process/results/word_list.h"

namespace diefill::process {
namespace {

constexpr std::size_t kMaxPoints = 100000;

const std::vector<std::string> kNames = {"time", "x", "y", "z", "angle"};

/// A column: -1 for time, else which of x, y, z, angle.
struct Column {
  int quantity;
  std::string unit;

  const std::string& name() const { return kNames[static_cast<std::size_t>(quantity + 1)]; }
};

Dimension dimension_of(const Column& column) {
  if (column.quantity < 0) return Dimension::time;
  return column.quantity < 3 ? Dimension::length : Dimension::angle;
}

Column column_of(const std::string& cell, const std::string& place) {
  const CsvHeading heading = csv_heading(cell);
  const auto found = std::find(kNames.begin(), kNames.end(), heading.name);
  if (found == kNames.end() || heading.unit.empty())
    throw SceneError(place + ": found column \"" + one_line(cell) +
                     "\"; allowed: time, x, y, z and angle, each with its unit, such as \"x mm\"");
  const Column column = {static_cast<int>(found - kNames.begin()) - 1, heading.unit};
  try {
    parse_quantity("1 " + column.unit, dimension_of(column));
  } catch (const UnitError& error) {
    throw SceneError(place + ": column " + heading.name + ": found unit \"" + one_line(column.unit) + "\", " +
                     error.what());
  }
  return column;
}

std::vector<Column> columns_of(const CsvFile& file) {
  std::vector<Column> columns;
  std::vector<std::string> names;
  for (std::size_t k = 0; k < file.cells().size(); ++k) {
    columns.push_back(column_of(file.cells()[k], file.place(k)));
    names.push_back(columns.back().name());
  }
  file.refuse_twice(names);
  if (std::find(names.begin(), names.end(), "time") == names.end())
    throw SceneError(file.place() + ": found no time column; start the heading with \"time s\"");
  if (names.size() < 2)
    throw SceneError(file.place() +
                     ": found only a time column; give where the tool is as well, in columns x, y, z or "
                     "angle, such as \"time s, x mm\"");
  return columns;
}

double value_in(const CsvFile& file, std::size_t cell, const Column& column) {
  file.number(cell, column.name());
  const std::string where = file.place(cell) + ": column " + column.name() + ": found ";
  double value = 0;
  try {
    value = parse_quantity(file.cells()[cell] + ' ' + column.unit, dimension_of(column));
  } catch (const UnitError& error) {
    throw SceneError(where + '"' + one_line(file.cells()[cell]) + "\", " + error.what());
  }
  const std::string found = where + one_line(file.cells()[cell]) + ' ' + column.unit;
  static const double longest = parse_quantity(motion_limits::kLongest, Dimension::time),
                      farthest = parse_quantity(motion_limits::kFarthest, Dimension::length);
  if (column.quantity < 0 && (value < 0 || value > longest))
    throw SceneError(found + ", allowed: 0 to " + std::string(motion_limits::kLongest));
  if (dimension_of(column) == Dimension::length && std::abs(value) > farthest)
    throw SceneError(found + ", allowed: -" + number_text(farthest) + " to " +
                     std::string(motion_limits::kFarthest));
  return value;
}

/// Refuses motions faster than any machine.
void refuse_too_fast(const MotionTable& table, double time, const Eigen::Vector4d& position,
                     const std::string& place) {
  const double span = time - table.time.back();
  const Eigen::Vector4d way = position - table.position.back();
  const double speed = way.head<3>().norm() / span, turn = std::abs(way[3]) / span;
  const auto refuse = [&](const std::string& found, const std::string& allowed) {
    throw SceneError(place + ": found a motion at " + found + " since the line before, allowed: up to " +
                     allowed + "; check the times and their unit");
  };
  static const double fastest = parse_quantity(motion_limits::kFastest, Dimension::velocity),
                      fastest_turn = parse_quantity(motion_limits::kFastestTurn, Dimension::angular_velocity);
  if (speed > fastest) refuse(number_text(speed) + " m/s", std::string(motion_limits::kFastest));
  if (turn > fastest_turn)
    refuse(number_text(turn * 30 / std::numbers::pi) + " rpm", std::string(motion_limits::kFastestTurn));
}

void add_point(MotionTable& table, const std::vector<Column>& columns, const CsvFile& file) {
  double time = 0;
  Eigen::Vector4d position = Eigen::Vector4d::Zero();
  for (std::size_t k = 0; k < columns.size(); ++k)
    (columns[k].quantity < 0 ? time : position[columns[k].quantity]) = value_in(file, k, columns[k]);
  const bool first = table.time.empty();
  if (first && (time != 0 || position.norm() != 0))
    throw SceneError(file.place() +
                     ": the first point must be all zeros, because a motion starts at the current position "
                     "of the tool");
  if (!first && time <= table.time.back()) {
    const auto [found, before] = numbers_apart(time, table.time.back());
    throw SceneError(file.place() + ": found the time " + found + " s after " + before +
                     " s; times must increase from line to line");
  }
  if (!first) refuse_too_fast(table, time, position, file.place());
  table.time.push_back(time);
  table.position.push_back(position);
}

CsvFile opened(const std::filesystem::path& file, const std::string& where) {
  constexpr std::size_t kLargest = 16U << 20U;  // bytes
  try {
    return {
        file, {"motion table", "but a motion is a CSV file of times and positions", kLargest}, where + ": "};
  } catch (const SceneError&) {
    throw;
  } catch (const std::runtime_error& reason) {
    throw SceneError(where + ": found \"" + file.string() + "\": " + reason.what() + "; give a CSV file");
  }
}

}  // namespace

MotionTable read_motion_table(const std::filesystem::path& path, const std::string& where) {
  CsvFile file = opened(path, where);
  MotionTable table;
  std::vector<Column> columns;
  if (file.next()) columns = columns_of(file);
  while (file.next()) {
    add_point(table, columns, file);
    if (table.time.size() > kMaxPoints)
      throw SceneError(file.place() + ": found more than " + std::to_string(kMaxPoints) +
                       " points; remove points on smooth parts of the path");
  }
  if (table.time.size() < 2)
    throw SceneError(where + ": found " + std::to_string(table.time.size()) + " points in " + path.string() +
                     "; a motion needs two or more below the heading line");
  return table;
}

TableMotion::TableMotion(std::vector<std::string> tools, const RotationAxis& axis, MotionTable table)
    : tools_(std::move(tools)), axis_(axis), table_(std::move(table)) {
  // Slope of the parabola through a point and its neighbours; at rest at both ends.
  slope_.assign(table_.time.size(), Eigen::Vector4d::Zero());
  for (std::size_t k = 1; k + 1 < slope_.size(); ++k) {
    const double before = table_.time[k] - table_.time[k - 1], after = table_.time[k + 1] - table_.time[k];
    const Eigen::Vector4d rise = (table_.position[k] - table_.position[k - 1]) / before,
                          next = (table_.position[k + 1] - table_.position[k]) / after;
    slope_[k] = (after * rise + before * next) / (before + after);
  }
}

ToolMotion TableMotion::motion(double time) const {
  const auto beyond = std::upper_bound(table_.time.begin(), table_.time.end(), time);
  const auto last = static_cast<std::ptrdiff_t>(table_.time.size()) - 1;
  const auto k = static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(beyond - table_.time.begin(), 1, last));
  const double span = table_.time[k] - table_.time[k - 1];
  const double s = std::clamp((time - table_.time[k - 1]) / span, 0.0, 1.0);
  const Eigen::Vector4d &from = table_.position[k - 1], &to = table_.position[k];
  const Eigen::Vector4d out = span * slope_[k - 1], in = span * slope_[k];
  const Eigen::Vector4d place =
      from + s * (out + s * ((3 * (to - from) - 2 * out - in) + s * (2 * (from - to) + out + in)));
  const Eigen::Vector4d rate =
      (out + s * (2 * (3 * (to - from) - 2 * out - in) + 3 * s * (2 * (from - to) + out + in))) / span;
  ToolMotion motion = axis_.turned(place[3], rate[3]);
  motion.translation = place.head<3>();
  motion.velocity = rate.head<3>();
  return motion;
}

std::string TableMotion::description() const {
  return results::and_list(tools_) + " following a table of " + std::to_string(table_.time.size()) +
         " points";
}

std::shared_ptr<Step> read_table_motion(TableReader& table, const std::vector<ToolSpec>& tools) {
  const auto moving = read_moving_tools(table, tools);
  const RotationAxis axis = read_rotation_axis(table);
  const std::string name = table.required_text("file", "shoe_motion.csv");
  return std::make_shared<TableMotion>(
      moving, axis, read_motion_table(table.file().parent_path() / name, table.where("file")));
}

}  // namespace diefill::process
