// Differences from measured data as measures of a comparison, in all and zone by zone.
#include "process/compare/measured_measures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "process/results/studies/job_list.h"
#include "tests/support/temporary_folder.h"

namespace diefill::process {
namespace {

constexpr const char* kZones =
    "[[measure.zone]]\nname = \"flange\"\nheights = [\"-8 mm\", \"0 mm\"]\n"
    "[[measure.zone]]\nname = \"upper hub\"\nouter_radius = \"5 mm\"\n";

/// A ring of 20 mm depth whose solid fraction rises with azimuth and height.
results::FillResult ring() {
  results::FillResult result;
  result.cavity.is_ring = true;
  result.cavity.lower_corner = {-0.01, -0.01, -0.02};
  result.cavity.upper_corner = {0.01, 0.01, 0};
  result.scene_text = kZones;
  results::Field2D map{"solid fraction", "azimuth", "deg", "height", "mm", {0, 180, 360}, {0, 10, 20}, {}, 0};
  for (const double height : map.second)
    for (const double azimuth : map.first) map.value.push_back(0.3 + 1e-4 * azimuth + 1e-3 * height);
  result.maps = {map};
  return result;
}

TEST(MeasuresAgainst, MeasuredDataHaveThoseOfEachZoneWithPlaces) {
  const support::TemporaryFolder folder;
  // 0.01 too low in the flange, which begins 12 mm above the floor, right below.
  folder.write("ct.csv",
               "azimuth [deg], height [mm], solid fraction [1]\n90, 2, 0.311\n90, 14, 0.313\n180, 16, 0.324\n"
               "270, 18, 0.335\n");
  const auto files = read_measured_files({(folder.path() / "ct.csv").string()});
  std::map<std::string, double> values;
  std::map<std::string, std::string> names;
  for (const FurtherMeasure& measure : measures_against(files, {"flange", "upper hub"})) {
    values[measure.about.key] = measure.value(ring());
    names[measure.about.key] = measure.about.name;
  }
  EXPECT_EQ(values.size(), 7U);
  EXPECT_NEAR(values.at("measured_ct_difference"), 0.0075, 1e-9);
  EXPECT_NEAR(values.at("measured_ct_difference_in_flange"), 0.01, 1e-9);
  EXPECT_NEAR(values.at("measured_ct_correlation_in_flange"), 1, 1e-9);
  EXPECT_EQ(names.at("measured_ct_difference_in_flange"), "mean difference from measured ct in flange");
  // A radius, which the map does not have.
  EXPECT_TRUE(std::isnan(values.at("measured_ct_difference_in_upper_hub")));
}

TEST(MeasuresAgainst, ZonesAreThoseOfAllJobsOnce) {
  const support::TemporaryFolder folder;
  results::write_job_list(folder.path(),
                          {"two", {"a", "b"}, {{"a", 1, "a"}, {"b", 1, "b"}, {"b", 2, "not there"}}});
  for (const char* job : {"a", "b"}) std::filesystem::create_directory(folder.path() / job);
  folder.write("a/scene.toml", kZones);
  folder.write("b/scene.toml",
               std::string(kZones) + "[[measure.zone]]\nname = \"rim\"\nheights = [\"-1 mm\", \"0 mm\"]\n");
  EXPECT_EQ(zones_of_jobs(folder.path()), (std::vector<std::string>{"flange", "upper hub", "rim"}));
}

}  // namespace
}  // namespace diefill::process
