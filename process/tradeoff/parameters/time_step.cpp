#include "process/tradeoff/parameters/parameters.h"
#include "process/tradeoff/work_estimate.h"

namespace diefill::process {
namespace {

/// The program may choose a shorter step than the usual fraction, and a scene may give one outright.
std::string current(const Scene& scene) {
  return number_text(time_step_fraction(scene));
}

}  // namespace

Parameter time_step_parameter() {
  return {.name = "time_step",
          .label = "time step over the critical one",
          .sign = "step",
          .finer = Finer::smaller,
          .current = current,
          .usual =
              [](const Scene&) {
                return std::vector<std::string>{"0.4", "0.3", "0.1"};
              },
          .changes =
              [](const Scene&, const std::string& value) {
                return SceneChanges{"numerics.time_step_fraction = " + toml_value(value) + '\n',
                                    {"numerics.time_step"}};
              }};
}

}  // namespace diefill::process
