#include "process/machine/motions/passage.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "process/input/scene_error.h"
#include "process/machine/motion_limits.h"
#include "process/machine/moving_tool.h"

namespace diefill::process {
namespace {

constexpr QuantityRule kVelocity = {Dimension::velocity, "0.2 m/s", "0 m/s", motion_limits::kFastest, true};
constexpr QuantityRule kAcceleration = {Dimension::acceleration, "10 m/s^2", "0 m/s^2", "10000 m/s^2", true};
constexpr QuantityRule kClearance = {Dimension::length, "2 mm", "0 mm", "1 m"};
constexpr QuantityRule kPause = {Dimension::time, "50 ms", "0 s", "60 s"};
constexpr QuantityRule kTravel = {Dimension::length, "60 mm", "0 mm", motion_limits::kFarthest, true};
constexpr int kMaxPassages = 1000;

struct Extent {
  double lower, upper;
};

/// Extent of a box along a unit vector.
Extent along(const Eigen::Vector3d& direction, const Eigen::Vector3d& lower, const Eigen::Vector3d& upper) {
  const Eigen::Vector3d centre = (lower + upper) / 2, half = (upper - lower) / 2;
  const double middle = direction.dot(centre), reach = direction.cwiseAbs().dot(half);
  return {middle - reach, middle + reach};
}

/// The first crossing's direction: a shoe that left the plate or cut into it would be a mistake.
Eigen::Vector3d level_direction(TableReader& table) {
  table.require("direction", "\"-x\"");
  Eigen::Vector3d direction = *table.direction("direction");
  constexpr double kLevel = 1e-6;
  if (std::abs(direction.z()) > kLevel)
    table.reject("direction",
                 "a passage is horizontal: expected \"-x\", \"+x\", \"-y\", \"+y\" or two numbers and 0, "
                 "such as [-1, 1, 0]; for other directions use kind = \"move\"");
  return direction;
}

}  // namespace

Passage::Passage(PassageSpec spec) : spec_(std::move(spec)) {
  if (spec_.travel) crossing_.emplace(*spec_.travel, spec_.velocity, spec_.acceleration);
}

std::shared_ptr<const Step> Passage::prepared(const MachineContext& context) const {
  if (spec_.travel) return nullptr;
  const Extent cavity = along(spec_.direction, context.cavity_lower, context.cavity_upper);
  if (!(cavity.upper > cavity.lower)) {
    throw SceneError(
        spec_.where +
        ": found no cavity below the fill plane to pass over; give the distance, such as travel = \"60 mm\"");
  }
  const Extent tool = along(spec_.direction, context.tool_lower, context.tool_upper);
  const double travel = cavity.upper + spec_.clearance - tool.lower;
  if (!(tool.lower < cavity.upper)) {
    throw SceneError(
        spec_.where + ": found \"" + spec_.tool + "\" already beyond the cavity (" +
        number_text((tool.lower - cavity.upper) * 1e3) +
        " mm past it along the direction of motion); start it on the other side or reverse direction");
  }
  auto passage = std::make_shared<Passage>(*this);
  passage->crossing_.emplace(travel, spec_.velocity, spec_.acceleration);
  return passage;
}

const StraightMove& Passage::crossing() const {
  if (!crossing_)
    throw std::logic_error("the motion of a passage was requested before the step was prepared");
  return *crossing_;
}

std::optional<double> Passage::duration() const {
  return spec_.passages * crossing().duration() + (spec_.passages - 1) * spec_.pause;
}

ToolMotion Passage::motion(double time) const {
  const StraightMove& move = crossing();
  const double period = move.duration() + spec_.pause;
  const int last = spec_.passages - 1;
  const int index =
      time <= 0 ? 0 : static_cast<int>(std::min(std::floor(time / period), static_cast<double>(last)));
  const double since = time - index * period;
  const bool forth = index % 2 == 0;
  ToolMotion motion;
  motion.translation = spec_.direction *
                       (forth ? move.position(since) : move.position(move.duration()) - move.position(since));
  motion.velocity = spec_.direction * (forth ? move.velocity(since) : -move.velocity(since));
  return motion;
}

std::string Passage::description() const {
  return std::to_string(spec_.passages) + (spec_.passages == 1 ? " passage at " : " passages at ") +
         number_text(spec_.velocity) + " m/s";
}

std::shared_ptr<Step> read_passage(TableReader& table, const std::vector<ToolSpec>& tools) {
  PassageSpec spec;
  spec.where = table.where("travel");
  spec.tool = read_moving_tool(table, tools, {ToolRole::shoe, ToolRole::plate});
  spec.velocity = table.required_quantity("velocity", kVelocity);
  spec.acceleration = table.quantity("acceleration", kAcceleration).value_or(spec.acceleration);
  spec.passages = static_cast<int>(table.integer("passages", 1, kMaxPassages).value_or(spec.passages));
  spec.direction = level_direction(table);
  spec.clearance = table.quantity("clearance", kClearance).value_or(spec.clearance);
  spec.pause = table.quantity("pause", kPause).value_or(spec.pause);
  spec.travel = table.quantity("travel", kTravel);
  return std::make_shared<Passage>(std::move(spec));
}

}  // namespace diefill::process
