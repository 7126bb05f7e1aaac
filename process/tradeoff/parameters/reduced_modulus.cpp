#include "process/tradeoff/parameters/parameters.h"

namespace diefill::process {
namespace {

std::string in_megapascals(double pascals) {
  return number_text(1e-6 * pascals) + " MPa";
}

/// The critical step goes with E~^(-2/5): a tenth costs 0.4 times as much.
std::vector<std::string> usual(const Scene& scene) {
  return {in_megapascals(0.1 * scene.powder.reduced_modulus),
          in_megapascals(0.3 * scene.powder.reduced_modulus),
          in_megapascals(3 * scene.powder.reduced_modulus)};
}

}  // namespace

Parameter reduced_modulus_parameter() {
  return {.name = "reduced_modulus",
          .label = "reduced modulus E~",
          .sign = "E~",
          .finer = Finer::larger,
          .dimension = Dimension::pressure,
          .current = [](const Scene& scene) { return in_megapascals(scene.powder.reduced_modulus); },
          .usual = usual,
          .changes = sets_key("powder.reduced_modulus")};
}

}  // namespace diefill::process
