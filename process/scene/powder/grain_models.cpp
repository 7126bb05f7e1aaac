#include "process/scene/powder/grain_models.h"

#include <algorithm>
#include <array>
#include <stdexcept>

namespace diefill::process {
namespace {

// Shapes: Bierwisch 2009, section 2.2; sizes: Table C.4; d / R: Table 4.1. Solid fractions at rest: Table 4.4
// for A and D; B and C lie between.
constexpr std::array kGrainModels = {
    GrainModelFacts{.model = GrainModel::A,
                    .name = "A",
                    .words = "a sphere that does not rotate",
                    .single_sphere = true,
                    .rotates = false,
                    .rolling_friction = false,
                    .sphere_radius = 1.5e-4,
                    .grain_diameter = 3.0e-4,
                    .over_radius = 2,
                    .settled = {{0.58, 0.55}, {0.48, 0.48}},
                    .shape = engine::model_a},
    GrainModelFacts{.model = GrainModel::B,
                    .name = "B",
                    .words = "a rotating sphere with rolling friction",
                    .single_sphere = true,
                    .rotates = true,
                    .rolling_friction = true,
                    .sphere_radius = 1.5e-4,
                    .grain_diameter = 3.0e-4,
                    .over_radius = 2,
                    .settled = {{0.57, 0.52}, {0.57, 0.52}},
                    .shape = engine::model_b},
    GrainModelFacts{.model = GrainModel::C,
                    .name = "C",
                    .words = "six overlapping spheres on an octahedron",
                    .single_sphere = false,
                    .rotates = true,
                    .rolling_friction = false,
                    .sphere_radius = 8.9e-5,
                    .grain_diameter = 3.56e-4,
                    .over_radius = 4,
                    .settled = {{0.50, 0.45}, {0.40, 0.40}},
                    .shape = engine::model_c},
    GrainModelFacts{.model = GrainModel::D,
                    .name = "D",
                    .words = "seven touching spheres",
                    .single_sphere = false,
                    .rotates = true,
                    .rolling_friction = false,
                    .sphere_radius = 7.84e-5,
                    .grain_diameter = 4.7e-4,
                    .over_radius = 6,
                    .settled = {{0.38, 0.32}, {0.32, 0.32}},
                    .shape = engine::model_d},
};

}  // namespace

std::span<const GrainModelFacts> grain_models() {
  return kGrainModels;
}

const GrainModelFacts& facts_of(GrainModel model) {
  const auto found = std::find_if(kGrainModels.begin(), kGrainModels.end(),
                                  [&](const GrainModelFacts& facts) { return facts.model == model; });
  if (found == kGrainModels.end()) throw std::logic_error("a grain model without a row in kGrainModels");
  return *found;
}

const char* name_of(GrainModel model) {
  return model == GrainModel::clump ? "clump" : facts_of(model).name;
}

bool has_single_spheres(const PowderSpec& powder) {
  return powder.model != GrainModel::clump && facts_of(powder.model).single_sphere;
}

bool rotates(const PowderSpec& powder) {
  return powder.model == GrainModel::clump || facts_of(powder.model).rotates;
}

bool has_rolling_friction(const PowderSpec& powder) {
  return powder.model != GrainModel::clump && facts_of(powder.model).rolling_friction;
}

bool stacks_in_columns(const PowderSpec& powder) {
  return !rotates(powder) && powder.work_of_adhesion > 0;
}

}  // namespace diefill::process
