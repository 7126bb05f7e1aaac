// Grains inside tools: where the grains are far finer than the tools are large.
#include "process/run/lost_grains.h"

#include <gtest/gtest.h>

#include "process/setup/read_tooling.h"
#include "project_paths.h"

namespace diefill::process {
namespace {

TEST(LostGrains, OfMicrometresAreLookedForInToolsOfCentimetres) {
  const Scene scene =
      read_scene(std::string(DIEFILL_SOURCE_DIR) + "/sample_tools/laboratory/adhesive_bed.toml");
  const Tooling tooling = read_tooling(scene);
  EXPECT_NO_THROW(LostGrains(tooling, {20e-6}));
}

}  // namespace
}  // namespace diefill::process
