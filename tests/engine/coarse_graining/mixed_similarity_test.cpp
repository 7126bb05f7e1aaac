// Powders of several kinds under scaled forces: similar grains move as the originals do.
#include <gtest/gtest.h>

#include "engine/coarse_graining/methods.h"
#include "tests/engine/laws/source_laws.h"
#include "tests/engine/mixed_support.h"

namespace diefill::engine {
namespace {

/// Largest distance (m) between a cloud of three kinds under `law` and the same cloud enlarged by `scale`
/// under `scaling`, places divided by it, after times in the same proportion. In empty space.
double unlikeness(const laws::LawParameters& law, const coarse_graining::ForceScaling& scaling) {
  const double scale = scaling.scale, step = 2e-8;
  const auto fine = mix_of({1, 0.6, 1.4}, law, law, law);
  auto coarse = fine;
  for (auto& kind : coarse.kinds)
    kind.shape = model_b(scale * kind.shape.sphere_radius, scale * scale * scale * kind.shape.mass);
  coarse.scaling = scaling;
  const auto cloud = mixed_cloud({3, 3, 3}, 2.3 * kMixRadius, 0.4, 3, 5);
  auto enlarged = cloud;
  for (auto& grain : enlarged) {
    grain.position *= scale;
    grain.angular_velocity /= scale;
  }
  Simulation original(settings_of(fine, step), {}), scaled(settings_of(coarse, scale * step), {});
  original.add_grains(cloud);
  scaled.add_grains(enlarged);
  EXPECT_GT(most_touching(original, 6000), 4U);
  run_steps(scaled, 6000);
  double most = 0;
  for (std::uint64_t id = 0; id < cloud.size(); ++id)
    most = std::max(most, (position_of(scaled, id) / scale - position_of(original, id)).norm());
  return most;
}

TEST(MixedCloud, GeometricallySimilarGrainsMoveAsTheOriginalsDo) {
  // Forces with l^2, torques with l^3, bodies with l^3 (Hu 2024, chapter 5, Method 2).
  for (const auto& source : laws::laws_of_the_sources()) {
    if (source.name == "Luding rolling") continue;  // its spring takes the scaled step for the original one
    EXPECT_LT(unlikeness(source.law, coarse_graining::hu_chapter_5_method_2(4)), 1e-7 * kMixRadius)
        << source.name;
  }
}

TEST(MixedCloud, ScaledUpParticlesWithoutTorquesMoveAsTheOriginalsDo) {
  // Torques grow with l^2 there (Hu 2024, section 3.4), which similar bodies do not: smooth spheres have
  // none.
  for (const auto& source : laws::laws_of_the_sources()) {
    auto smooth = source.law;
    smooth.friction = {};
    smooth.rolling = {};
    EXPECT_LT(unlikeness(smooth, coarse_graining::scaled_up_particle(4)), 1e-7 * kMixRadius) << source.name;
  }
}

}  // namespace
}  // namespace diefill::engine
