#include <algorithm>

#include "process/scene/reading/sections.h"

namespace diefill::process {
namespace {

constexpr QuantityRule kParticleDiameter = {Dimension::length, "0.1 mm", "1 um", "10 mm"};
constexpr QuantityRule kViscosity = {Dimension::viscosity, "1.8e-5 Pa s", "1e-7 Pa s", "1 Pa s"};
constexpr NumberRule kSolidFraction = {0.05, 0.74, false, "0.32"};

/// The path of the air is fixed in the laboratory, as is the die.
void refuse_moving_die(TableReader& table, const Scene& scene) {
  for (const ToolSpec& tool : scene.tools) {
    if (tool.role != ToolRole::die) continue;
    for (const auto& step : scene.steps) {
      const auto moved = step->tools();
      if (std::ranges::find(moved, tool.name) != moved.end())
        table.reject("tool", "the step \"" + step->description() + "\" moves the die \"" + tool.name +
                                 "\", but [suction] needs a die at rest; remove [suction] or the step");
    }
  }
}

}  // namespace

SuctionSpec read_suction(TableReader& table, const Scene& scene) {
  Choices<std::string> names;
  for (const ToolSpec& tool : scene.tools) names.emplace_back(tool.name, tool.name);
  SuctionSpec suction;
  suction.tool = table.required_choice("tool", names);
  suction.particle_diameter = table.required_quantity("particle_diameter", kParticleDiameter);
  suction.viscosity = table.quantity("viscosity", kViscosity).value_or(suction.viscosity);
  suction.solid_fraction = table.number("solid_fraction", kSolidFraction).value_or(suction.solid_fraction);
  refuse_moving_die(table, scene);
  if (scene.economy.sleep || scene.economy.carry_beyond)
    table.reject("tool", std::string("economy.") + (scene.economy.sleep ? "sleep" : "carry_beyond") +
                             " freezes grains that the air would move; remove one of the two");
  table.finish();
  return suction;
}

}  // namespace diefill::process
