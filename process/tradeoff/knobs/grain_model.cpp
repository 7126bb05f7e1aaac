#include "process/tradeoff/knobs/knobs.h"

namespace diefill::process {
namespace {

const std::vector<std::string> kModels = {"A", "B", "C", "D"};

std::string current(const Scene& scene) {
  return kModels[static_cast<std::size_t>(scene.powder.model)];
}

}  // namespace

Knob grain_model_knob() {
  return {.name = "grain_model",
          .label = "grain model",
          .sign = "model",
          .finer = Finer::as_listed,
          .words = kModels,
          .current = current,
          .usual = [](const Scene&) { return kModels; },
          .changes = sets_key("powder.model")};
}

}  // namespace diefill::process
