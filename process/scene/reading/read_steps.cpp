#include <algorithm>
#include <functional>

#include "process/input/scene_error.h"
#include "process/machine/actions/settle.h"
#include "process/machine/free_motion.h"
#include "process/machine/step_registry.h"
#include "process/scene/reading/sections.h"

namespace diefill::process {
namespace {

using Steps = std::vector<std::shared_ptr<const Step>>;
/// What must have happened before the start (2 k) or the end (2 k + 1) of step k can.
using Needs = std::vector<std::vector<std::size_t>>;

StepPlan read_plan(TableReader& table, const std::vector<std::string>& tools) {
  StepPlan plan;
  plan.where = table.where("kind");
  if (table.has("name")) plan.name = table.required_name("name", "first passage");
  plan.start = read_condition(table, "start", tools);
  plan.until = read_condition(table, "until", tools);
  return plan;
}

/// Index of the step of that name; throws SceneError that `condition` names none.
std::size_t step_named(const Steps& steps, const std::string& name, const Condition& condition) {
  std::string names;
  for (std::size_t k = 0; k < steps.size(); ++k) {
    if (steps[k]->plan.name.empty()) continue;
    if (steps[k]->plan.name == name) return k;
    names += (names.empty() ? "\"" : ", \"") + steps[k]->plan.name + '"';
  }
  throw SceneError(
      condition.where + ": found \"" + name + "\", but " +
      (names.empty() ? "no step has a name; add name = \"" + name + '"' : "the named steps are " + names));
}

/// What a condition waits for.
std::vector<std::size_t> events_of(const Steps& steps, const Condition& condition) {
  std::vector<std::size_t> events;
  if (!condition.after.empty()) events.push_back(2 * step_named(steps, condition.after, condition) + 1);
  if (!condition.with.empty()) events.push_back(2 * step_named(steps, condition.with, condition));
  return events;
}

Needs needs_of(const Steps& steps) {
  Needs needs(2 * steps.size());
  const auto add = [&](std::size_t event, const Condition& condition) {
    for (const std::size_t need : events_of(steps, condition)) needs[event].push_back(need);
  };
  for (std::size_t k = 0; k < steps.size(); ++k) {
    const StepPlan& plan = steps[k]->plan;
    needs[2 * k + 1].push_back(2 * k);
    if (plan.start)
      add(2 * k, *plan.start);
    else if (k > 0)
      needs[2 * k].push_back(2 * k - 1);
    if (!plan.until) continue;
    add(2 * k + 1, *plan.until);
    // A step that also ends by itself waits for nobody.
    if (!steps[k]->open_ended()) needs[2 * k + 1].resize(1);
  }
  return needs;
}

void refuse_steps_that_wait_for_themselves(const Steps& steps, const Needs& needs) {
  enum class Seen : char { no, on_the_way, yes };
  std::vector<Seen> seen(needs.size(), Seen::no);
  const std::function<void(std::size_t)> follow = [&](std::size_t event) {
    if (seen[event] == Seen::on_the_way)
      throw SceneError(
          steps[event / 2]->plan.where + ": the " + (event % 2 == 0 ? "start" : "end") +
          " of this step depends on itself through other steps; change start or until of one of them");
    if (seen[event] == Seen::yes) return;
    seen[event] = Seen::on_the_way;
    for (const std::size_t need : needs[event]) follow(need);
    seen[event] = Seen::yes;
  };
  for (std::size_t event = 0; event < needs.size(); ++event) follow(event);
}

/// Whether `event` can only come once `earlier` has; `needs` has no circle.
bool comes_after(const Needs& needs, std::size_t event, std::size_t earlier) {
  std::vector<std::size_t> open = {event};
  std::vector<bool> seen(needs.size(), false);
  while (!open.empty()) {
    const std::size_t next = open.back();
    open.pop_back();
    if (next == earlier) return true;
    if (seen[next]) continue;
    seen[next] = true;
    open.insert(open.end(), needs[next].begin(), needs[next].end());
  }
  return false;
}

/// A step that ends by itself, and whose `until` can only be met once it has ended.
void refuse_until_without_effect(const Steps& steps, const Needs& needs) {
  for (std::size_t k = 0; k < steps.size(); ++k) {
    const auto& until = steps[k]->plan.until;
    if (!until) continue;
    for (const std::size_t event : events_of(steps, *until)) {
      if (!comes_after(needs, event, 2 * k + 1)) continue;
      const std::string& named = steps[event / 2]->plan.name;
      throw SceneError(
          until->where + ": found \"" + named + "\", " +
          (event / 2 == k ? "which is this step itself" : "which waits for the end of this step") +
          ", so the condition never ends it; name a step that is not after it, or remove until");
    }
  }
}

void refuse_same_names(const Steps& steps, TableReader& table) {
  const std::string& name = steps.back()->plan.name;
  if (name.empty()) return;
  const bool taken =
      std::any_of(steps.begin(), steps.end() - 1, [&](const auto& step) { return step->plan.name == name; });
  if (taken) table.reject("name", "an earlier step already has this name; names must be unique");
}

/// Without an end of its own a step that only waits lasts until the powder rests; any other needs one.
void refuse_excessive_work(const Step& step, TableReader& table) {
  if (!step.open_ended() || step.plan.until) return;
  if (step.tools().empty() && step.inflow() == nullptr) return;
  const std::string own = step.inflow() != nullptr ? "mass = \"5 g\"" : "duration = \"1 s\"";
  throw SceneError(table.where("until") + ": this step has no end; give " + own +
                   ", or until = { after = \"name of a step\" } or another condition");
}

/// The poured powder settles once, before all else.
void refuse_late_settling(const Steps& steps, TableReader& table) {
  const auto* settle = dynamic_cast<const Settle*>(steps.back().get());
  if (settle == nullptr || !settle->from_start()) return;
  if (steps.size() > 1) table.reject("from_start", "only the first step may settle the poured powder");
  if (settle->plan.start) table.reject("from_start", "a step from the start has no condition; remove start");
}

}  // namespace

std::vector<std::shared_ptr<const Step>> read_steps(TableReader& document,
                                                    const std::vector<ToolSpec>& tools) {
  std::vector<std::string> names;
  for (const ToolSpec& tool : tools) names.push_back(tool.name);
  Steps steps;
  for (TableReader& table : document.tables("step")) {
    const StepFactory make = table.required_choice("kind", step_kinds());
    const auto step = make(table, tools);
    step->plan = read_plan(table, names);
    steps.push_back(step);
    table.finish();
    refuse_same_names(steps, table);
    refuse_excessive_work(*steps.back(), table);
    refuse_late_settling(steps, table);
  }
  const Needs needs = needs_of(steps);
  refuse_steps_that_wait_for_themselves(steps, needs);
  refuse_until_without_effect(steps, needs);
  refuse_driven_free_tools(steps);
  return steps;
}

}  // namespace diefill::process
