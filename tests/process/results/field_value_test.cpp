// Profiles and fields between their nodes, and round the circle.
#include "process/results/field_value.h"

#include <gtest/gtest.h>

#include <cmath>

#include "process/results/places_without_value.h"

namespace diefill::results {
namespace {

/// Of the value that equals its azimuth, from the first node to the first one of the next turn.
double sawtooth(double azimuth, double first, double last) {
  while (azimuth < first) azimuth += 360;
  while (azimuth > first + 360) azimuth -= 360;
  if (azimuth <= last) return azimuth;
  const double share = (azimuth - last) / (first + 360 - last);
  return (1 - share) * last + share * first;
}

/// Azimuths from `first` in steps, the last one included.
std::vector<double> azimuths(double first, double step, double last) {
  std::vector<double> all;
  for (double x = first; x <= last; x += step) all.push_back(x);
  return all;
}

constexpr double kPlaces[] = {-725, -400, -170, -90, -10, -2, 0, 2, 5, 90, 357, 358, 362, 400, 725};

TEST(FieldValue, AzimuthsOfAnOpenProfileContinueRoundTheCircle) {
  Profile profile{"fill level", "mm", "azimuth", "deg", azimuths(5, 10, 355), {}};
  profile.y = profile.x;
  for (const double place : kPlaces)
    EXPECT_NEAR(value_at(profile, place), sawtooth(place, 5, 355), 1e-9) << place;
  EXPECT_NEAR(value_at(profile, -90), 270, 1e-9);
  EXPECT_NEAR(value_at(profile, 400), 40, 1e-9);
}

TEST(FieldValue, AzimuthsOfAClosedMapContinueRoundTheCircle) {
  Field2D map{"solid fraction", "azimuth", "deg", "height", "mm", azimuths(0, 30, 360), {0, 10}, {}, 0};
  for (const double height : map.second)
    for (const double azimuth : map.first) map.value.push_back(azimuth + 1000 * height);
  for (const double place : kPlaces) {
    const double within = std::fmod(place + 3600, 360);
    EXPECT_NEAR(value_at(map, place, 5), within + 5000, 1e-9) << place;
  }
  EXPECT_EQ(value_at(map, 360, 0), 360);  // the node itself
  EXPECT_TRUE(std::isnan(value_at(map, 90, 10.1)));
}

TEST(FieldValue, OtherCoordinatesEndAtTheirNodes) {
  const Profile profile{"solid fraction", "1", "height", "mm", {1, 2, 4}, {10, 20, 40}};
  EXPECT_NEAR(value_at(profile, 3), 30, 1e-12);
  EXPECT_EQ(value_at(profile, 4), 40);
  for (const double place : {0.9, 4.1, -359.0, std::nan("")})
    EXPECT_TRUE(std::isnan(value_at(profile, place))) << place;
}

TEST(FieldValue, PlacesWithoutValueCountOnlyWhereTheyHaveAShare) {
  Field2D map{"solid fraction", "x", "mm", "y", "mm", {0, 1, 2}, {0, 1}, {}, 0};
  map.value = {1, std::nan(""), unvalued_powder(), 1, 2, unvalued_powder()};
  EXPECT_EQ(value_at(map, 0, 0), 1);
  EXPECT_TRUE(std::isnan(value_at(map, 0.5, 0)));
  EXPECT_NEAR(value_at(map, 0.5, 1), 1.5, 1e-12);
  EXPECT_TRUE(is_unvalued_powder(value_at(map, 1.5, 1)));
  EXPECT_FALSE(is_unvalued_powder(value_at(map, 1.5, 0.5)));  // a hole beside it
  EXPECT_TRUE(std::isnan(value_at(Field2D{}, 0, 0)));
}

}  // namespace
}  // namespace diefill::results
