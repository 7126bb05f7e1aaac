// Contacts of a bed from positions alone.
#include "process/laboratory/published/contact_statistics.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "process/laboratory/layer_profile.h"
#include "process/laboratory/published/perform.h"

namespace diefill::process::laboratory {
namespace {

/// Single spheres of 2 mm at these places.
results::PowderState spheres(const std::vector<Eigen::Vector3d>& places) {
  results::PowderState powder;
  powder.grain_diameter = 2e-3;
  powder.sphere_radius = 1e-3;
  powder.sphere_offsets = {Eigen::Vector3d::Zero()};
  powder.position = places;
  powder.orientation.assign(places.size(), Eigen::Vector4d(1, 0, 0, 0));
  return powder;
}

TEST(ContactStatistics, OverlapsOfAChainAreThoseOfItsDistances) {
  const auto chain = spheres({{0, 0, 0}, {1.998e-3, 0, 0}, {3.996e-3, 0, 0}});
  const auto contacts = contact_statistics(chain, 2e-4);
  EXPECT_NEAR(contacts.mean_overlap, 1e-3, 1e-9);  // 2 um of 2 mm
  EXPECT_NEAR(contacts.contacts_a_grain, 4.0 / 3, 1e-12);
  EXPECT_NEAR(contacts.peak_overlap, 1e-3, 2e-4);
}

TEST(ContactStatistics, ContactsAcrossAPeriodCount) {
  auto pair = spheres({{-3.999e-3, 0, 0}, {3.999e-3, 0, 0}});
  EXPECT_EQ(contact_statistics(pair).contacts_a_grain, 0);
  pair.period = {9.99e-3, 0, 0};  // 1.992 mm from image to image
  EXPECT_NEAR(contact_statistics(pair).contacts_a_grain, 1, 1e-12);
  EXPECT_NEAR(contact_statistics(pair).mean_overlap, 4e-3, 1e-9);
}

TEST(ContactStatistics, GrainsNearGroundAndTopAreLeftOut) {
  // A column of twelve spheres, d = 2 mm; those in the middle overlap more.
  std::vector<Eigen::Vector3d> places = {{0, 0, 1e-3}};
  for (int k = 1; k < 12; ++k)
    places.push_back({0, 0, places.back().z() + (k > 4 && k < 8 ? 1.996e-3 : 1.998e-3)});
  const auto column = spheres(places);
  const auto counts = away_from_ends(column, 3.9);  // 7.8 mm: the fifth to the eighth
  EXPECT_EQ(std::count(counts.begin(), counts.end(), true), 4);
  const auto all = contact_statistics(column, 2e-4), middle = contact_statistics(column, 2e-4, 3.9);
  EXPECT_NEAR(all.contacts_a_grain, 22.0 / 12, 1e-12);
  EXPECT_NEAR(middle.contacts_a_grain, 2, 1e-12);
  // Of eight sides six are of a contact of 2e-3 d, two of one of 1e-3 d.
  EXPECT_NEAR(middle.mean_overlap, 1.75e-3, 1e-9);
  EXPECT_LT(all.mean_overlap, middle.mean_overlap);
}

TEST(LayerProfile, OfOneSphereIsItsCrossSections) {
  auto bed = spheres({{0, 0, 1e-3}, {0, 0, 9e-3}});
  const auto profile = layer_profile(bed, 16e-6);
  ASSERT_GT(profile.height.size(), 20U);
  EXPECT_NEAR(profile.height[10], 0.5, 1e-12);
  EXPECT_NEAR(profile.share[10], 3.14159265 * 1e-6 / 16e-6, 1e-8);  // its equator
  EXPECT_NEAR(profile.share[0], 0, 1e-12);
}

TEST(Verdict, AsksForTheMeanWithinTheLimits) {
  results::LabRow row;
  row.lower = 1, row.upper = 2;
  EXPECT_EQ(verdict_of(row), "no value");
  row.values = {0.9, 1.3};
  EXPECT_EQ(verdict_of(row), "met");
  row.values = {0.9, 1.0};
  EXPECT_EQ(verdict_of(row), "not met");
  row.lower = row.upper = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(verdict_of(row), "-");
}

}  // namespace
}  // namespace diefill::process::laboratory
