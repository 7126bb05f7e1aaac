#include "process/scene/powder/grain_models.h"
#include "process/tradeoff/parameters/parameters.h"

namespace diefill::process {
namespace {

std::vector<std::string> models() {
  std::vector<std::string> names;
  for (const GrainModelFacts& facts : grain_models()) names.emplace_back(facts.name);
  return names;
}

/// A clump of the scene's own is none of the models: there is nothing to compare them with.
bool has_clump(const Scene& scene) {
  return scene.powder.model == GrainModel::clump;
}

std::string current_model(const Scene& scene) {
  return name_of(scene.powder.model);
}

std::vector<std::string> usual_models(const Scene& scene) {
  return has_clump(scene) ? std::vector<std::string>{} : models();
}

SceneChanges changed_model(const Scene& scene, const std::string& value) {
  if (has_clump(scene))
    throw SceneError(
        "the grains of this scene are a clump of its own (powder.spheres or spheres_file), which no grain "
        "model replaces; leave out this parameter");
  return sets_key("powder.model")(scene, value);
}

}  // namespace

Parameter grain_model_parameter() {
  return {.name = "grain_model",
          .label = "grain model",
          .sign = "model",
          .finer = Finer::as_listed,
          .words = models(),
          .current = current_model,
          .usual = usual_models,
          .changes = changed_model};
}

}  // namespace diefill::process
