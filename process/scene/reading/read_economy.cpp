#include <cmath>

#include "process/machine/actions/powder_change.h"
#include "process/machine/actions/powder_inflow.h"
#include "process/scene/contact/contact_spec.h"
#include "process/scene/reading/sections.h"

namespace diefill::process {
namespace {

constexpr QuantityRule kSleepAfter = {Dimension::time, "5 ms", "0 s", "10 s", true};
constexpr QuantityRule kCarryBeyond = {Dimension::length, "20 mm", "0 mm", "1 m"};
constexpr NumberRule kSleepEnergy = {0, 0.1, true, "1e-4"};
constexpr NumberRule kWakeForce = {0, 0.9, true, "0.5"};

/// Powder that sleeps in a shaking tool would be shaken by the walls' grip alone, and wake at once.
void refuse_while_shaken(TableReader& table, const Scene& scene, const std::string& key) {
  for (const auto& step : scene.steps)
    if (step->stays() && !step->tools().empty())
      table.reject(key, "the step \"" + step->description() +
                            "\" shakes or turns a tool, and sleeping powder would not move with it; remove "
                            "the key or the step");
}

void refuse_period_across(TableReader& table, const Scene& scene, int axis) {
  if (!scene.numerics.period[static_cast<std::size_t>(axis)]) return;
  const std::string name = axis == 0 ? "x" : "y";
  table.reject("mirror", "numerics.periodic repeats the scene along " + name +
                             ", but a half model has a wall there; remove one of the two");
}

/// Grains would be poured on one side of the mirror plane only, and doubled.
void refuse_lopsided(TableReader& table, const Eigen::Vector3d& lower, const Eigen::Vector3d& upper, int axis,
                     const std::string& what) {
  constexpr double kEqual = 1e-6;  // m
  if (std::abs(lower[axis] + upper[axis]) <= kEqual) return;
  table.reject("mirror", what + " reaches from " + number_text(1e3 * lower[axis]) + " to " +
                             number_text(1e3 * upper[axis]) + " mm along " + (axis == 0 ? "x" : "y") +
                             "; a half model needs the same extent on both sides of 0");
}

void refuse_gravity_across(TableReader& table, const Scene& scene, int axis) {
  const auto refuse = [&](const Eigen::Vector3d& gravity, const std::string& whose) {
    if (gravity[axis] != 0)
      table.reject("mirror", "gravity" + whose + " has a component across the mirror plane (" +
                                 number_text(gravity[axis]) +
                                 " m/s^2), so the two halves would not be mirror images; remove the key");
  };
  refuse(scene.gravity, "");
  for (const auto& step : scene.steps)
    if (const PowderChange* change = step->change(); change != nullptr && change->gravity)
      refuse(*change->gravity, " of the step \"" + step->description() + "\"");
}

void check_mirror(TableReader& table, Scene& scene) {
  const int axis = *scene.economy.mirror;
  refuse_gravity_across(table, scene, axis);
  refuse_period_across(table, scene, axis);
  refuse_lopsided(table, scene.pour.lower, scene.pour.upper, axis, "the box of [pour]");
  for (const auto& step : scene.steps) {
    const PowderInflow* inflow = step->inflow();
    if (inflow == nullptr) continue;
    refuse_lopsided(table, inflow->lower, inflow->upper, axis,
                    "the box of the step \"" + step->description() + "\"");
    if (std::abs(inflow->velocity[axis]) > 0)
      table.reject(
          "mirror",
          "the step \"" + step->description() +
              "\" feeds powder across the mirror plane; a half model needs a velocity parallel to it");
  }
  scene.pour.lower[axis] = 0;
  if (scene.pour.upper[axis] >= scene.powder.grain_diameter) return;
  table.reject("mirror", "half of the box of [pour] is narrower than a grain; remove the key");
}

}  // namespace

void read_economy(TableReader table, Scene& scene) {
  static const Choices<int> planes = {{"x", 0}, {"y", 1}};
  EconomySpec& economy = scene.economy;
  economy.sleep = table.flag("sleep").value_or(economy.sleep);
  economy.sleep_after = table.quantity("sleep_after", kSleepAfter).value_or(economy.sleep_after);
  economy.sleep_energy = table.number("sleep_energy", kSleepEnergy).value_or(economy.sleep_energy);
  economy.wake_force = table.number("wake_force", kWakeForce).value_or(economy.wake_force);
  economy.mirror = table.choice("mirror", planes);
  economy.drop_spilled = table.flag("drop_spilled").value_or(economy.drop_spilled);
  economy.skip_far_walls = table.flag("skip_far_walls").value_or(economy.skip_far_walls);
  economy.carry_beyond = table.quantity("carry_beyond", kCarryBeyond);
  table.finish();
  if (economy.sleep) refuse_while_shaken(table, scene, "sleep");
  if (economy.carry_beyond) {
    economy.carry_place = table.where("carry_beyond");
    refuse_while_shaken(table, scene, "carry_beyond");
    if (economy.sleep)
      table.reject(
          "carry_beyond",
          "carrying powder cannot be combined with economy.sleep, which is on; remove one of the two");
  }
  if (economy.mirror) {
    economy.mirror_place = table.where("mirror");
    check_mirror(table, scene);
  }
}

}  // namespace diefill::process
