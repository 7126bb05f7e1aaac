#include "render/snapshot.h"

#include "tests/render/drawing_test.h"
#include "tests/render/synthetic_ring.h"

namespace diefill::render::test {
namespace {

using Snapshot = Drawing;

TEST_F(Snapshot, ShowsRing) {
  const auto picture = compose_snapshot(make_ring());
  keep(picture.image, "snapshot.png");
  EXPECT_EQ(picture.image.size(), QSize(1600, 1200));
}

}  // namespace
}  // namespace diefill::render::test
