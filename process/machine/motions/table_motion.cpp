#include "process/machine/motions/table_motion.h"

#include <algorithm>
#include <sstream>
#include <string_view>

#include "process/input/csv_cells.h"
#include "process/input/scene_error.h"
#include "process/input/shown_value.h"
#include "process/input/text_file.h"
#include "process/machine/moving_tool.h"
#include "process/results/word_list.h"

namespace diefill::process {
namespace {

constexpr std::size_t kMostPoints = 100000;

/// A column: -1 for time, else which of x, y, z, angle.
struct Column {
  int quantity;
  std::string unit;
};

Dimension dimension_of(const Column& column) {
  if (column.quantity < 0) return Dimension::time;
  return column.quantity < 3 ? Dimension::length : Dimension::angle;
}

Column column_of(const std::string& heading, const std::string& place) {
  const std::size_t end = heading.find_first_of(" \t[(");
  const std::string name = heading.substr(0, end);
  std::string unit = end == std::string::npos ? "" : heading.substr(end);
  std::erase_if(unit,
                [](char letter) { return letter == '[' || letter == ']' || letter == '(' || letter == ')'; });
  const std::vector<std::string> names = {"time", "x", "y", "z", "angle"};
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end() || trimmed_cell(unit).empty())
    throw SceneError(place + ": found column \"" + one_line(heading) +
                     "\"; allowed: time, x, y, z and angle, each with its unit, such as \"x mm\"");
  return {static_cast<int>(found - names.begin()) - 1, trimmed_cell(unit)};
}

void add_point(MotionTable& table, const std::vector<Column>& columns, const std::string& line,
               const std::string& place) {
  const auto cells = csv_cells(line);
  if (cells.size() != columns.size())
    throw SceneError(place + ": found " + std::to_string(cells.size()) + " values, expected " +
                     std::to_string(columns.size()) + ", one per column");
  double time = 0;
  Eigen::Vector4d position = Eigen::Vector4d::Zero();
  for (std::size_t k = 0; k < cells.size(); ++k) {
    double value = 0;
    try {
      value = parse_quantity(cells[k] + ' ' + columns[k].unit, dimension_of(columns[k]));
    } catch (const UnitError& error) {
      throw SceneError(place + ": found \"" + one_line(cells[k]) + "\", " + error.what());
    }
    (columns[k].quantity < 0 ? time : position[columns[k].quantity]) = value;
  }
  const bool first = table.time.empty();
  if (first ? time != 0 || position.norm() != 0 : time <= table.time.back())
    throw SceneError(place + (first ? ": the first point must be all zeros, because a motion starts at the "
                                      "current position of the tool"
                                    : ": times must increase from line to line"));
  table.time.push_back(time);
  table.position.push_back(position);
}

/// The table as text; a byte order mark, as spreadsheets write it, is none of it.
std::string motion_text(const std::filesystem::path& file, const std::string& where) {
  constexpr std::size_t kLargest = 16U << 20U;  // bytes
  constexpr std::string_view kMark = "\xEF\xBB\xBF";
  try {
    std::string text =
        load_text_file(file, {"motion table", "but a motion is a CSV file of times and positions", kLargest});
    return text.starts_with(kMark) ? text.substr(kMark.size()) : text;
  } catch (const std::runtime_error& reason) {
    throw SceneError(where + ": found \"" + file.string() + "\": " + reason.what() + "; give a CSV file");
  }
}

}  // namespace

MotionTable read_motion_table(const std::filesystem::path& file, const std::string& where) {
  std::istringstream stream(motion_text(file, where));
  MotionTable table;
  std::vector<Column> columns;
  int number = 0;
  for (std::string line; std::getline(stream, line);) {
    const std::string place = where + ": " + file.string() + ":" + std::to_string(++number);
    if (trimmed_cell(line).empty()) continue;
    if (!columns.empty()) {
      add_point(table, columns, line, place);
      if (table.time.size() > kMostPoints)
        throw SceneError(place + ": found more than " + std::to_string(kMostPoints) +
                         " points; remove points on smooth parts of the path");
      continue;
    }
    for (const auto& heading : csv_cells(line)) columns.push_back(column_of(heading, place));
    if (std::none_of(columns.begin(), columns.end(), [](const Column& c) { return c.quantity < 0; }))
      throw SceneError(place + ": found no time column; start the heading with \"time s\"");
  }
  if (table.time.size() < 2)
    throw SceneError(where + ": found " + std::to_string(table.time.size()) + " points in " + file.string() +
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
