#include "process/tooling/co_moving_powder.h"

#include <algorithm>
#include <cmath>

namespace diefill::process {

namespace {

[[noreturn]] void refuse(const Scene& scene, const std::string& why) {
  throw SceneError(scene.economy.carry_place + ": " + why + "; remove the key");
}

std::size_t only_shoe(const Scene& scene, const Tooling& tooling) {
  const auto is_shoe = [](const Tool& tool) { return tool.spec.role == ToolRole::shoe; };
  const auto count = std::count_if(tooling.tools.begin(), tooling.tools.end(), is_shoe);
  if (count == 0) refuse(scene, "no tool has the role \"shoe\", so nothing carries powder");
  if (count > 1)
    refuse(scene, std::to_string(count) + " tools have the role \"shoe\", but only one can carry powder");
  const auto shoe = std::find_if(tooling.tools.begin(), tooling.tools.end(), is_shoe);
  return static_cast<std::size_t>(shoe - tooling.tools.begin());
}

bool turns(const Step& step) {
  constexpr int kInstants = 200;
  constexpr double kOpenEnded = 1, kNoSpin = 1e-12;  // s; rad/s
  if (step.control() != nullptr) return true;
  const double length = step.open_ended() ? kOpenEnded : step.duration().value_or(kOpenEnded);
  for (int n = 0; n < kInstants; ++n)
    if (step.motion(length * n / kInstants).angular_velocity.norm() > kNoSpin) return true;
  return false;
}

void check_steps(const Scene& scene, const std::string& shoe, const std::string& die) {
  for (const auto& step : scene.steps) {
    const auto tools = step->tools();
    const auto moves = [&](const std::string& name) {
      return std::find(tools.begin(), tools.end(), name) != tools.end();
    };
    if (moves(die))
      refuse(scene, "the step \"" + step->description() +
                        "\" moves the die, and with it the region where powder must be free to flow");
    if (moves(shoe) && turns(*step))
      refuse(scene, "the step \"" + step->description() +
                        "\" turns the shoe or moves it by force, but powder can only be carried along a "
                        "prescribed path");
  }
}

/// Everything above and below a cavity, and as far beside it as powder is to be free.
Eigen::AlignedBox3d free_powder(const geometry::Cavity& cavity, double beyond) {
  constexpr double kFar = 1e3;  // m
  Eigen::Vector3d lower = cavity.box.lower, upper = cavity.box.upper;
  lower.head<2>().array() -= beyond;
  upper.head<2>().array() += beyond;
  lower.z() = -kFar;
  upper.z() = kFar;
  return {lower, upper};
}

}  // namespace

std::optional<engine::SleepSettings> co_moving_powder(const Scene& scene, const Tooling& tooling) {
  const auto& beyond = scene.economy.carry_beyond;
  if (!beyond) return std::nullopt;
  if (!tooling.cavity.found)
    refuse(scene, "the tools enclose no cavity, so the region where powder flows is unknown");
  const std::size_t shoe = only_shoe(scene, tooling);
  check_steps(scene, tooling.tools[shoe].spec.name, tooling.tools[tooling.die].spec.name);
  auto settings = engine::co_moving_with(shoe);
  settings.awake.push_back(free_powder(tooling.cavity, *beyond));
  for (const auto& cavity : tooling.other_cavities) settings.awake.push_back(free_powder(cavity, *beyond));
  return settings;
}

}  // namespace diefill::process
