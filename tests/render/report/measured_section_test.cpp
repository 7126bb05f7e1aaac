// Results beside measured data in reports: what must be read and seen is there.
#include "render/report/sections/measured_section.h"

#include <gtest/gtest.h>

#include <cmath>

#include "render/report/html.h"
#include "tests/render/fields/drawing_test.h"

namespace diefill::render::report {
namespace {

class MeasuredSection : public test::Drawing {};

results::MeasuredComparison level() {
  results::MeasuredComparison comparison;
  comparison.name = "ring_level";
  comparison.quantity = "fill level";
  comparison.unit = "mm";
  comparison.first_name = "azimuth";
  comparison.first_unit = "deg";
  comparison.first = {45, 135, 225, 315};
  comparison.measured = {10, 11, 12, 11};
  comparison.deviation = {0.2, 0.2, 0.2, 0.2};
  comparison.simulated = {10.5, 11.5, 12.5, NAN};
  comparison.zones = {{"all", 3, 11, 11.5, 0.53, 0.98}, {"azimuth 0 to 90 deg", 1, 10, 10.5, 0.5, NAN}};
  return comparison;
}

results::MeasuredComparison density(bool grid) {
  results::MeasuredComparison comparison;
  comparison.name = "ct";
  comparison.quantity = "solid fraction";
  comparison.unit = "1";
  comparison.first_name = "x";
  comparison.second_name = "y";
  comparison.first_unit = comparison.second_unit = "mm";
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 5; ++i) {
      comparison.first.push_back(grid ? i : i + 0.1 * j);
      comparison.second.push_back(grid ? j : j + 0.1 * i);
      comparison.measured.push_back(0.3 + 0.01 * i);
      comparison.simulated.push_back(0.31 + 0.01 * j);
      comparison.deviation.push_back(NAN);
    }
  comparison.zones = {{"all", 20, 0.32, 0.325, 0.02, 0.1}};
  return comparison;
}

std::vector<std::string> suffixes(const results::MeasuredComparison& comparison) {
  std::vector<std::string> all;
  for (const auto& picture : measured_pictures(comparison)) {
    EXPECT_FALSE(picture.figure.png.isEmpty()) << picture.suffix;
    all.push_back(picture.suffix);
  }
  return all;
}

TEST_F(MeasuredSection, HasTheStatisticsZoneByZoneAndThePlacesWithoutValue) {
  Document document;
  document.sections = {measured_section({level()}, 1)};
  const std::string page = html_page(document);
  for (const char* part : {"Against measured data", "ring_level", "azimuth 0 to 90 deg", "0.53", "0.98",
                           "mean 0.5 mm", "1 of 4 measured places have no simulated value"})
    EXPECT_NE(page.find(part), std::string::npos) << part;
}

TEST_F(MeasuredSection, PicturesAreThoseOfTheKindOfData) {
  EXPECT_EQ(suffixes(level()), (std::vector<std::string>{"", "_difference"}));
  EXPECT_EQ(suffixes(density(true)), (std::vector<std::string>{"", "_simulated", "_difference", "_scatter"}));
  EXPECT_EQ(suffixes(density(false)), (std::vector<std::string>{"_scatter"}));
}

// Most pixels of the references' grey in one row: a level broken line has half a row's, letters a few.
int most_grey_in_a_row(const QImage& image) {
  int most = 0;
  for (int row = 0; row < image.height(); ++row) {
    int count = 0;
    for (int column = 0; column < image.width(); ++column)
      count += test::close_to(test::pixel_at(image, QPointF(column, row)), {90, 90, 90}, 3);
    most = std::max(most, count);
  }
  return most;
}

TEST_F(MeasuredSection, NoDifferenceIsAGreyReferenceLine) {
  auto both_signs = level();
  both_signs.simulated = {10.5, 10.5, 12.5, 10.5};
  QImage difference;
  for (const auto& picture : measured_pictures(both_signs))
    if (picture.suffix == "_difference") difference = QImage::fromData(picture.figure.png);
  ASSERT_FALSE(difference.isNull());
  EXPECT_GT(most_grey_in_a_row(difference), difference.width() / 4);
}

TEST_F(MeasuredSection, TheTextForTerminalsHasALineForEachZone) {
  const std::string text = measured_text(level());
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 4);
  EXPECT_NE(text.find("1 of 4 measured places have no simulated value"), std::string::npos) << text;
  EXPECT_NE(text.find("correlation 0.98"), std::string::npos) << text;
}

}  // namespace
}  // namespace diefill::render::report
