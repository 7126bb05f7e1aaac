#include "process/machine/actions/powder_inflow.h"

namespace diefill::process {
namespace {

constexpr QuantityRule kCorner = {Dimension::length, "20 mm", "-10 m", "10 m"};
constexpr QuantityRule kMass = {Dimension::mass, "5 g", "0 kg", "1000 kg", true};
constexpr QuantityRule kRate = {Dimension::mass_rate, "20 g/s", "0 kg/s", "1000 kg/s", true};
constexpr QuantityRule kVelocity = {Dimension::velocity, "-0.3 m/s", "-10 m/s", "10 m/s"};

}  // namespace

std::string Inflow::description() const {
  const std::string powder = inflow_.powder.empty() ? "powder" : inflow_.powder;
  const std::string amount = inflow_.mass ? number_text(1e3 * *inflow_.mass) + " g of " + powder : powder;
  return amount + (inflow_.rate ? " fed at " + number_text(1e3 * *inflow_.rate) + " g/s"
                                : " fed as space becomes free");
}

std::shared_ptr<Step> read_inflow(TableReader& table, const std::vector<ToolSpec>& tools) {
  PowderInflow inflow;
  inflow.where = table.where("from");
  inflow.lower = table.required_point("from", kCorner);
  inflow.upper = table.required_point("to", kCorner);
  if (((inflow.upper - inflow.lower).array() < 0).any())
    table.reject("to", "it must not be less than from along any axis");
  inflow.velocity = table.point("velocity", kVelocity).value_or(inflow.velocity);
  inflow.mass = table.quantity("mass", kMass);
  inflow.rate = table.quantity("rate", kRate);
  inflow.powder = table.text("powder").value_or("");
  Choices<std::string> names;
  for (const ToolSpec& tool : tools) names.emplace_back(tool.name, tool.name);
  inflow.with = table.choice("with", names).value_or("");
  return std::make_shared<Inflow>(std::move(inflow));
}

}  // namespace diefill::process
