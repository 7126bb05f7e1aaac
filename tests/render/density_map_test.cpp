#include "render/density_map.h"

#include <cmath>

#include "tests/render/drawing_test.h"
#include "tests/render/synthetic_ring.h"

namespace diefill::render::test {
namespace {

using DensityMap = Drawing;
const ColourRange kFromData{std::nan(""), std::nan("")};

TEST_F(DensityMap, X) {
  keep(compose_field(make_map(), "1 passage at 0.2 m/s", "Dist. AE, grain model D, grain size 1.88 mm",
                     kFromData)
           .image,
       "map.png");
  keep(compose_field(make_section().field, "1 passage at 0.2 m/s",
                     "Dist. AE, grain model D, grain size 1.88 mm", kFromData)
           .image,
       "section.png");
}

}  // namespace
}  // namespace diefill::render::test
