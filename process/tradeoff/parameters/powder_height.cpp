#include "process/tradeoff/parameters/parameters.h"

namespace diefill::process {
namespace {

std::vector<std::string> usual(const Scene& scene) {
  return {in_millimetres(0.5 * scene.pour.fill_height), in_millimetres(0.7 * scene.pour.fill_height)};
}

}  // namespace

Parameter powder_height_parameter() {
  return {.name = "powder_height",
          .label = "height of powder in the shoe",
          .sign = "powder",
          .finer = Finer::larger,
          .dimension = Dimension::length,
          .current = [](const Scene& scene) { return in_millimetres(scene.pour.fill_height); },
          .usual = usual,
          .changes = sets_key("pour.fill_height")};
}

}  // namespace diefill::process
