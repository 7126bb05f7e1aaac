#include "process/machine/actions/powder_change.h"

#include "process/input/scene_error.h"

namespace diefill::process {
namespace {

constexpr QuantityRule kGravity = {Dimension::acceleration, "-9.81 m/s^2", "-1000 m/s^2", "1000 m/s^2"};
constexpr QuantityRule kVelocity = {Dimension::velocity, "0.1 m/s", "0 m/s", "10 m/s"};
constexpr QuantityRule kAdhesion = {Dimension::work_of_adhesion, "0.01 J/m^2", "0 J/m^2", "10 J/m^2"};
constexpr NumberRule kFriction = {0, 10, false, "0.5"};

}  // namespace

std::string Change::description() const {
  std::string text;
  const auto add = [&](bool changes, const char* what) {
    if (changes) text += (text.empty() ? "" : ", ") + std::string(what);
  };
  add(change_.gravity.has_value(), "gravity");
  add(change_.changes_laws(), "contact laws");
  add(change_.at_rest, "rest");
  add(change_.random_velocity > 0, "random velocities");
  return "change of " + text;
}

std::shared_ptr<Step> read_change(TableReader& table, const std::vector<ToolSpec>&) {
  PowderChange change;
  change.gravity = table.point("gravity", kGravity);
  change.friction = table.number("friction", kFriction);
  change.wall_friction = table.number("wall_friction", kFriction);
  change.work_of_adhesion = table.quantity("work_of_adhesion", kAdhesion);
  change.wall_work_of_adhesion = table.quantity("wall_work_of_adhesion", kAdhesion);
  change.at_rest = table.flag("at_rest").value_or(false);
  change.random_velocity = table.quantity("random_velocity", kVelocity).value_or(0);
  const bool names_laws = table.table("contact").has_value();
  const bool moves_powder = change.at_rest || change.random_velocity > 0;
  if (!change.gravity && !change.changes_laws() && !names_laws && !moves_powder)
    throw SceneError(table.where("kind") +
                     ": this step changes nothing; give gravity, friction, wall_friction, work_of_adhesion, "
                     "wall_work_of_adhesion, at_rest, random_velocity or [step.contact]");
  return std::make_shared<Change>(std::move(change));
}

}  // namespace diefill::process
