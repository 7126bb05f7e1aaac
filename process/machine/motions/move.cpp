#include "process/machine/motions/move.h"

#include <cmath>

#include "process/machine/motion_limits.h"
#include "process/machine/moving_tool.h"
#include "process/results/word_list.h"

namespace diefill::process {
namespace {

constexpr QuantityRule kVelocity = {Dimension::velocity, "0.02 m/s", "0 m/s", motion_limits::kFastest, true};
constexpr QuantityRule kAcceleration = {Dimension::acceleration, "10 m/s^2", "0 m/s^2", "10000 m/s^2", true};
constexpr QuantityRule kDistance = {Dimension::length, "20 mm", "0 mm", motion_limits::kFarthest, true};
constexpr QuantityRule kStation = {Dimension::length, "20 mm", motion_limits::kFarthestBack,
                                   motion_limits::kFarthest};
constexpr QuantityRule kPause = {Dimension::time, "50 ms", "0 s", "60 s"};

std::vector<double> read_stations(TableReader& table) {
  const auto distance = table.quantity("distance", kDistance);
  std::vector<double> stations = table.quantities("stations", kStation);
  if (distance && !stations.empty())
    table.reject("stations", "distance is given as well; remove one of the two");
  if (distance) return {*distance};
  if (stations.empty()) table.require("distance", "\"20 mm\"");
  double before = 0;
  for (const double station : stations) {
    if (station == before)
      table.reject("stations",
                   "two consecutive stations are the same (the start is 0 mm); use pause or a step of kind "
                   "\"wait\" for a rest");
    before = station;
  }
  return stations;
}

}  // namespace

Move::Move(MoveSpec spec) : spec_(std::move(spec)) {
  if (spec_.stations.empty()) throw std::invalid_argument("a move needs a station to go to");
  double before = 0;
  for (const double station : spec_.stations) {
    legs_.emplace_back(std::abs(station - before), spec_.velocity, spec_.acceleration);
    before = station;
  }
}

std::optional<double> Move::duration() const {
  double whole = static_cast<double>(legs_.size() - 1) * spec_.pause;
  for (const auto& leg : legs_) whole += leg.duration();
  return whole;
}

ToolMotion Move::motion(double time) const {
  double from = 0;
  std::size_t n = 0;
  for (; n + 1 < legs_.size() && time >= legs_[n].duration() + spec_.pause; ++n) {
    time -= legs_[n].duration() + spec_.pause;
    from = spec_.stations[n];
  }
  const double sense = spec_.stations[n] > from ? 1 : -1;
  ToolMotion motion;
  motion.translation = (from + sense * legs_[n].position(time)) * spec_.direction;
  motion.velocity = sense * legs_[n].velocity(time) * spec_.direction;
  return motion;
}

double Move::stopping_time(double) const {
  return 2 * spec_.velocity / spec_.acceleration;
}

std::string Move::description() const {
  const std::string tools = results::and_list(spec_.tools), speed = number_text(spec_.velocity) + " m/s";
  if (legs_.size() > 1) return tools + " over " + std::to_string(legs_.size()) + " stations at " + speed;
  return tools + " by " + number_text(1e3 * spec_.stations.front()) + " mm at " + speed;
}

std::shared_ptr<Step> read_move(TableReader& table, const std::vector<ToolSpec>& tools) {
  MoveSpec spec;
  spec.tools = read_moving_tools(table, tools);
  table.require("direction", "\"-z\"");
  spec.direction = *table.direction("direction");
  spec.stations = read_stations(table);
  spec.velocity = table.required_quantity("velocity", kVelocity);
  spec.acceleration = table.quantity("acceleration", kAcceleration).value_or(spec.acceleration);
  spec.pause = table.quantity("pause", kPause).value_or(spec.pause);
  return std::make_shared<Move>(std::move(spec));
}

}  // namespace diefill::process
