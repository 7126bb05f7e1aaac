#include "process/machine/condition.h"

namespace diefill::process {
namespace {

constexpr QuantityRule kAt = {Dimension::time, "0.3 s", "0 s", "10000 s"};
constexpr QuantityRule kDelay = {Dimension::time, "50 ms", "0 s", "1000 s"};
constexpr QuantityRule kRestTime = {Dimension::time, "10 ms", "0 s", "100 s", true};
constexpr NumberRule kRestEnergy = {0, 1, true, "1e-4"};
constexpr QuantityRule kMass = {Dimension::mass, "10 g", "0 kg", "1000 kg", true};
constexpr QuantityRule kForce = {Dimension::force, "5 N", "0 N", "1e6 N", true};

Choices<std::string> as_choices(const std::vector<std::string>& names) {
  Choices<std::string> choices;
  for (const auto& name : names) choices.emplace_back(name, name);
  return choices;
}

void read_rest(TableReader& table, Condition& condition) {
  condition.at_rest = table.flag("at_rest").value_or(false);
  const auto energy = table.number("rest_energy", kRestEnergy);
  const auto time = table.quantity("rest_time", kRestTime);
  if (!energy && !time) return;
  if (!condition.at_rest)
    table.reject(energy ? "rest_energy" : "rest_time", "this key requires at_rest = true; add it");
  condition.limits.emplace();
  condition.limits->energy = energy.value_or(condition.limits->energy);
  condition.limits->time = time.value_or(condition.limits->time);
}

}  // namespace

std::optional<Condition> read_condition(TableReader& owner, const std::string& key,
                                        const std::vector<std::string>& tools) {
  auto table = owner.table(key);
  if (!table) return std::nullopt;
  Condition condition;
  condition.where = owner.where(key);
  condition.after = table->text("after").value_or("");
  condition.with = table->text("with").value_or("");
  condition.at = table->quantity("at", kAt);
  const auto delay = table->quantity("delay", kDelay);
  condition.delay = delay.value_or(0);
  read_rest(*table, condition);
  condition.filled_mass = table->quantity("filled_mass", kMass);
  condition.force = table->quantity("force", kForce);
  if (condition.force)
    condition.on = table->required_choice("on", as_choices(tools));
  else if (table->has("on"))
    table->reject("on", "this key requires a force; add one, such as force = \"5 N\"");
  table->finish();
  const bool dated = !condition.after.empty() || !condition.with.empty() || condition.at || delay;
  if (!dated && !condition.measures())
    owner.reject(key,
                 "the condition is empty; give one or more of after, with, at, delay, at_rest, "
                 "filled_mass, force");
  return condition;
}

}  // namespace diefill::process
