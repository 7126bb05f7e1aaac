#include "render/style/colour_bar.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

namespace diefill::render::test {
namespace {

TEST(ColourBar, ARangeThatIsNoneIsNamedInAShortLine) {
  try {
    make_colour_bar("", {}, {-1e308, 1e308});
    FAIL() << "the length of the range is infinite";
  } catch (const std::runtime_error& error) {
    EXPECT_EQ(std::string(error.what()),
              "colour range: the lower limit -1e+308 must be below the upper limit 1e+308");
  }
}

}  // namespace
}  // namespace diefill::render::test
