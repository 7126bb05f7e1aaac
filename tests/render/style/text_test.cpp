#include "render/style/text.h"

#include <gtest/gtest.h>

namespace diefill::render {
namespace {

TEST(AxisLabel, BeginsWithACapitalAndEndsWithTheUnit) {
  EXPECT_EQ(axis_label("solid fraction", "").toStdString(), "Solid fraction [–]");
  EXPECT_EQ(axis_label("azimuth", "deg").toStdString(), "Azimuth [°]");
  EXPECT_EQ(axis_label("x", "mm").toStdString(), "x [mm]");
}

TEST(AxisLabel, LeavesKeysAsScenesSpellThem) {
  EXPECT_EQ(axis_label("powder.friction", "1").toStdString(), "powder.friction [–]");
  EXPECT_EQ(axis_label("log10 of work_of_adhesion", "J/m^2").toStdString(),
            "log10 of work_of_adhesion [J/m^2]");
}

}  // namespace
}  // namespace diefill::render
