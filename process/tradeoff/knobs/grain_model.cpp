#include "process/tradeoff/knobs/knobs.h"

namespace diefill::process {
namespace {

const std::vector<std::string> kModels = {"A", "B", "C", "D"};

/// A clump of the scene's own is none of the models: there is nothing to compare them with.
bool has_clump(const Scene& scene) {
  return scene.powder.model == GrainModel::clump;
}

std::string current_model(const Scene& scene) {
  return has_clump(scene) ? "clump" : kModels.at(static_cast<std::size_t>(scene.powder.model));
}

std::vector<std::string> usual_models(const Scene& scene) {
  return has_clump(scene) ? std::vector<std::string>{} : kModels;
}

SceneChanges changed_model(const Scene& scene, const std::string& value) {
  if (has_clump(scene))
    throw SceneError(
        "the grains of this scene are a clump of its own (powder.spheres or spheres_file), which no grain "
        "model replaces; leave out this knob");
  return sets_key("powder.model")(scene, value);
}

}  // namespace

Knob grain_model_knob() {
  return {.name = "grain_model",
          .label = "grain model",
          .sign = "model",
          .finer = Finer::as_listed,
          .words = kModels,
          .current = current_model,
          .usual = usual_models,
          .changes = changed_model};
}

}  // namespace diefill::process
