// A filling in which grains jam between shoe and die runs to its end at a step that a single wedged sphere
// would bear and a jam would not: what swings up is sheared off before it gains energy.
#include <gtest/gtest.h>

#include "engine/observe/energy_balance.h"
#include "process/powder/material.h"
#include "process/run/fill_run.h"
#include "process/setup/build_tooling.h"
#include "process/tooling/tooling.h"
#include "project_paths.h"
#include "tests/support/scene_text.h"
#include "tests/support/temporary_folder.h"

namespace diefill::process {
namespace {

TEST(Jams, DoNotStopAFillingAgainstFineWallSpheresAtALongStep) {
  const auto file = std::filesystem::path(DIEFILL_SOURCE_DIR) / "sample_tools/narrow_ring/fill.toml";
  std::string text = support::exchanged(support::contents(file), "spacing = 2.4", "spacing = 1.6");
  text = support::exchanged(text, "[numerics]", "[numerics]\ntime_step_fraction = 0.2");
  const Scene scene = parse_scene(text, file);
  const auto settings = engine_settings(scene, 1);
  ASSERT_GT(settings.time_step, wedged_time_step(scene, settings))
      << "no longer step than a jam is thought to bear";
  const Tooling tooling =
      build_tooling(scene, settings.shape().sphere_radius, 2 * settings.shape().bounding_radius());
  const support::TemporaryFolder folder;
  RunOptions options;
  options.directory = folder.path();
  options.show_progress = false;
  const Scene followed = with_prepared_steps(scene, tooling);
  FillRun run(followed, tooling, options);
  run.run();
  EXPECT_LT(energy_balance_error(run.simulation()), 0.005);
  EXPECT_GT(run.grains_sheared(), 0U);
  EXPECT_LT(run.grains_sheared(), 12U) << "of 3,941";
  RecordProperty("grains_sheared", static_cast<int>(run.grains_sheared()));
}

}  // namespace
}  // namespace diefill::process
