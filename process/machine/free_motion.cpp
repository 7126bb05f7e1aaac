#include "process/machine/free_motion.h"

#include <algorithm>
#include <cmath>

#include "process/input/scene_error.h"
#include "process/machine/motion_limits.h"
#include "process/machine/moving_tool.h"

namespace diefill::process {
namespace {

constexpr QuantityRule kMass = {Dimension::mass, "30 g", "0 kg", "1000 kg", true};
constexpr QuantityRule kDensity = {Dimension::density, "7200 kg/m^3", "0 kg/m^3", "25000 kg/m^3", true};
constexpr QuantityRule kVelocity = {Dimension::velocity, "-5 m/s", "-100 m/s", "100 m/s"};
constexpr QuantityRule kSpin = {Dimension::angular_velocity, "0 rpm", motion_limits::kFastestTurnBack,
                                motion_limits::kFastestTurn};
constexpr QuantityRule kForce = {Dimension::force, "0 N", "-1e6 N", "1e6 N"};
constexpr QuantityRule kDistance = {Dimension::length, "20 mm", "0 mm", motion_limits::kFarthest};
constexpr QuantityRule kDuration = {Dimension::time, "0.1 s", "0 s", motion_limits::kLongest, true};
constexpr QuantityRule kRecord = {Dimension::time, "1 ms", "0 s", "1000 s", true};
constexpr NumberRule kRestitution = {0, 1, false, "0"};

void read_stops(TableReader& table, engine::FreeBodySpec& body) {
  std::vector<TableReader> stops = table.tables("stops");
  if (stops.size() > engine::FreeBodySpec::kMaxStops)
    table.reject("stops", "allowed: at most " + std::to_string(engine::FreeBodySpec::kMaxStops) + " stops");
  for (TableReader& entry : stops) {
    engine::TravelStop& stop = body.stops[body.stop_count++];
    entry.require("direction", "\"-z\"");
    stop.direction = *entry.direction("direction");
    stop.distance = entry.required_quantity("distance", kDistance);
    stop.restitution = entry.number("restitution", kRestitution).value_or(0);
    if (!body.guide.isZero() && stop.direction.cross(body.guide).norm() > 1e-9)
      entry.reject("direction", "the tool moves along its guide only; give a direction along it");
    entry.finish();
  }
}

void read_guide(TableReader& table, engine::FreeBodySpec& body) {
  const auto guide = table.direction("guide");
  if (guide) body.guide = *guide;
  if (guide && table.has("angular_velocity"))
    table.reject("angular_velocity", "a tool on a guide does not turn; remove the key");
  body.turns = !guide && table.flag("turns").value_or(true);
  if (guide && table.has("turns")) table.reject("turns", "a tool on a guide does not turn; remove the key");
}

void read_start(TableReader& table, engine::FreeBodySpec& body) {
  body.velocity = table.point("velocity", kVelocity).value_or(Eigen::Vector3d::Zero());
  if (!body.guide.isZero() && body.velocity.cross(body.guide).norm() > 1e-9 * body.velocity.norm())
    table.reject("velocity", "the tool moves along its guide only; give a velocity along it");
  if (!body.guide.isZero()) return;
  const auto spin = table.point("angular_velocity", kSpin);
  if (spin && !body.turns)
    table.reject("angular_velocity", "the tool does not turn (turns = false); remove one of the two");
  body.angular_velocity = spin.value_or(Eigen::Vector3d::Zero());
}

}  // namespace

std::shared_ptr<const Step> FreeTool::prepared(const MachineContext& context) const {
  auto step = std::make_shared<FreeTool>(*this);
  step->gravity_ = context.gravity;
  step->middle_ = 0.5 * (context.tool_lower + context.tool_upper);
  return step;
}

ToolMotion FreeTool::motion(double time) const {
  const engine::FreeBodySpec& body = free_.body;
  // Where the mass follows from the CAD, a constant force is left out: its effect is not known without the
  // mass.
  Eigen::Vector3d rate = gravity_;
  if (body.mass > 0) rate += body.drive / body.mass;
  if (!body.guide.isZero()) rate = rate.dot(body.guide) * body.guide;
  ToolMotion motion;
  motion.pivot = middle_;
  motion.translation = body.velocity * time + 0.5 * time * time * rate;
  motion.velocity = body.velocity + time * rate;
  if (body.turns && body.angular_velocity.norm() > 0) {
    motion.rotation =
        Eigen::AngleAxisd(body.angular_velocity.norm() * time, body.angular_velocity.normalized())
            .toRotationMatrix();
    motion.angular_velocity = body.angular_velocity;
  }
  for (std::size_t k = 0; k < body.stop_count; ++k) {
    const engine::TravelStop& stop = body.stops[k];
    const double beyond = stop.direction.dot(motion.translation) - stop.distance;
    if (beyond < 0) continue;
    motion.translation -= beyond * stop.direction;
    motion.velocity -= std::max(0.0, stop.direction.dot(motion.velocity)) * stop.direction;
  }
  return motion;
}

ToolMotion FreeTool::motion_stopped(double time, double stop) const {
  ToolMotion motion = this->motion(std::min(time, stop));
  if (time < stop) return motion;
  motion.velocity.setZero();
  motion.angular_velocity.setZero();
  return motion;
}

std::string FreeTool::description() const {
  return "free motion of " + tool_;
}

const FreeMotion* free_motion_of(const Step& step) {
  const auto* free = dynamic_cast<const FreeTool*>(&step);
  return free == nullptr ? nullptr : &free->free_motion();
}

std::shared_ptr<Step> read_free_motion(TableReader& table, const std::vector<ToolSpec>& tools) {
  Choices<std::string> names;
  for (const ToolSpec& tool : tools) names.emplace_back(tool.name, tool.name);
  const std::string tool = table.required_choice("tool", names);
  FreeMotion free;
  const auto mass = table.quantity("mass", kMass), density = table.quantity("density", kDensity);
  if (mass && density) table.reject("density", "mass is given as well; remove one of the two");
  if (!mass && !density) table.require("density", "\"7800 kg/m^3\", or mass = \"30 g\"");
  free.body.mass = mass.value_or(0);
  free.density = density.value_or(0);
  read_guide(table, free.body);
  read_start(table, free.body);
  free.body.drive = table.point("force", kForce).value_or(Eigen::Vector3d::Zero());
  read_stops(table, free.body);
  free.record = table.quantity("record", kRecord).value_or(free.record);
  return std::make_shared<FreeTool>(tool, free, table.quantity("duration", kDuration));
}

void refuse_driven_free_tools(const std::vector<std::shared_ptr<const Step>>& steps) {
  for (std::size_t k = 0; k < steps.size(); ++k) {
    if (free_motion_of(*steps[k]) == nullptr) continue;
    const std::string tool = steps[k]->tools().front();
    for (std::size_t other = 0; other < steps.size(); ++other) {
      const auto moved = steps[other]->tools();
      if (other == k || std::find(moved.begin(), moved.end(), tool) == moved.end()) continue;
      throw SceneError(steps[std::max(k, other)]->plan.where + ": tool \"" + tool +
                       "\" has a free motion and moves by forces alone; remove the other step that moves it");
    }
  }
}

}  // namespace diefill::process
