#include "tests/render/synthetic_ring.h"

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

namespace diefill::render::test {
namespace {

constexpr double kInner = 8e-3, kOuter = 12.46e-3, kDepth = 20e-3;
constexpr double kGrainSize = 1.88e-3, kSphereRadius = kGrainSize / 6;
constexpr double kPi = std::numbers::pi;
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

double surface_height(double azimuth) {
  return 18 - 2 * std::exp(-std::pow((azimuth - 180) / 40, 2));
}

void start_powder(results::PowderState& powder) {
  powder.time = 1.25;
  powder.grain_diameter = kGrainSize;
  powder.sphere_radius = kSphereRadius;
  powder.sphere_offsets = {Eigen::Vector3d::Zero()};
  for (int axis = 0; axis < 3; ++axis)
    for (const double sign : {-1.0, 1.0})
      powder.sphere_offsets.push_back(sign * 2 * kSphereRadius * Eigen::Vector3d::Unit(axis));
  powder.grain_solid_volume = 7 * 4.0 / 3 * kPi * std::pow(kSphereRadius, 3);
  powder.grain_mass = 7000 * powder.grain_solid_volume;
}

void add_grain(results::FillResult& result, const Eigen::Vector3d& place, bool in_cavity,
               std::mt19937_64& random) {
  std::uniform_real_distribution<double> jitter(-0.12 * kGrainSize, 0.12 * kGrainSize), turn(-1, 1);
  Eigen::Vector4d orientation(turn(random), turn(random), turn(random), turn(random));
  result.powder.id.push_back(result.powder.id.size());
  result.powder.position.push_back(place + Eigen::Vector3d(jitter(random), jitter(random), jitter(random)));
  result.powder.orientation.push_back(orientation.normalized());
  result.powder.velocity.push_back(Eigen::Vector3d::Zero());
  result.powder.angular_velocity.push_back(Eigen::Vector3d::Zero());
  const double azimuth = std::fmod(std::atan2(place.y(), place.x()) * 180 / kPi + 360, 360);
  const double height = (place.z() + kDepth) * 1e3;
  const double value = synthetic_fraction(azimuth, height) + 0.03 * turn(random);
  result.solid_fraction.solid_fraction.push_back(value);
  result.solid_fraction.cell_volume.push_back(result.powder.grain_solid_volume / value);
  result.solid_fraction.open.push_back(!in_cavity || height > surface_height(azimuth) - 2.0);
  result.solid_fraction.in_cavity.push_back(in_cavity);
}

void fill_cavity(results::FillResult& result, std::mt19937_64& random) {
  constexpr double kSpacing = 0.80 * kGrainSize;
  for (double z = -kDepth + 0.5 * kGrainSize; z < -2e-3; z += kSpacing)
    for (double radius = kInner + 0.5 * kGrainSize; radius < kOuter - 0.3 * kGrainSize; radius += kSpacing) {
      const int around = static_cast<int>(2 * kPi * radius / kSpacing);
      for (int k = 0; k < around; ++k) {
        const double angle = 2 * kPi * k / around + z * 400;
        const double azimuth = std::fmod(angle * 180 / kPi + 36000, 360);
        if ((z + kDepth) * 1e3 > surface_height(azimuth)) continue;
        add_grain(result, {radius * std::cos(angle), radius * std::sin(angle), z}, true, random);
      }
    }
}

void fill_shoe(results::FillResult& result, std::mt19937_64& random) {
  for (double x = 17e-3; x < 29e-3; x += 0.85 * kGrainSize)
    for (double y = -12e-3; y < 12e-3; y += 0.85 * kGrainSize)
      for (double z = 0.5 * kGrainSize; z < 7e-3; z += 0.85 * kGrainSize)
        add_grain(result, {x, y, z}, false, random);
}

}  // namespace

double synthetic_fraction(double azimuth, double height) {
  return 0.36 - 0.002 * height + 0.03 * std::cos((azimuth - 30) * kPi / 180);
}

results::ToolState make_tube(const std::string& role, double inner_radius, double outer_radius, double lower,
                             double upper, const Eigen::Vector2d& centre, int sides) {
  results::ToolState tool;
  tool.name = tool.role = role;
  for (int k = 0; k < sides; ++k) {
    const double angle = 2 * kPi * (k + 0.5) / sides;
    const Eigen::Vector2d way(std::cos(angle), std::sin(angle));
    for (const double radius : {inner_radius, outer_radius})
      for (const double z : {lower, upper}) {
        const Eigen::Vector2d place = centre + radius * way;
        tool.vertices.emplace_back(place.x(), place.y(), z);
      }
  }
  // Corner of side k: inner lower, inner upper, outer lower, outer upper.
  const auto quad = [&tool](int a, int b, int c, int d) {
    tool.triangles.emplace_back(a, b, c);
    tool.triangles.emplace_back(a, c, d);
  };
  for (int k = 0; k < sides; ++k) {
    const int here = 4 * k, next = 4 * ((k + 1) % sides);
    quad(here + 2, next + 2, next + 3, here + 3);
    quad(here + 3, next + 3, next + 1, here + 1);
    quad(here, next, next + 2, here + 2);
    if (inner_radius > 0) quad(here + 1, next + 1, next, here);
  }
  return tool;
}

results::Field2D make_map() {
  results::Field2D map{"solid fraction", "azimuth", "deg", "height", "mm", {}, {}, {}, kGrainSize};
  for (int k = 0; k < 72; ++k) map.first.push_back(5.0 * k);
  for (int k = 0; k <= 40; ++k) map.second.push_back(0.5 * k);
  for (const double height : map.second)
    for (const double azimuth : map.first)
      map.value.push_back(height > surface_height(azimuth) ? kNone : synthetic_fraction(azimuth, height));
  return map;
}

results::SectionField make_section() {
  results::SectionField section;
  section.plane.name = "y = 0";
  section.field = {"solid fraction", "x", "mm", "z", "mm", {}, {}, {}, kGrainSize};
  for (int k = 0; k <= 104; ++k) section.field.first.push_back(-13 + 0.25 * k);
  for (int k = 0; k <= 84; ++k) section.field.second.push_back(-20.5 + 0.25 * k);
  for (const double z : section.field.second)
    for (const double x : section.field.first) {
      const double azimuth = x > 0 ? 0 : 180;
      const bool inside =
          std::abs(x) > 8 && std::abs(x) < 12.46 && z > -20 && z + 20 < surface_height(azimuth);
      section.field.value.push_back(inside ? synthetic_fraction(azimuth, z + 20) : kNone);
    }
  return section;
}

results::FillResult make_ring() {
  results::FillResult result;
  result.title = "1 passage at 0.2 m/s, Dist. AE, d = 1.88 mm";
  result.strategy = "1 passage at 0.2 m/s";
  result.powder_name = "Dist. AE, grain model D";
  start_powder(result.powder);
  std::mt19937_64 random(7);
  fill_cavity(result, random);
  fill_shoe(result, random);
  result.tools = {make_tube("die", kOuter, 24e-3, -kDepth - 8e-3, 0, {0, 0}, 96),
                  make_tube("core", 0, kInner, -kDepth - 8e-3, 0, {0, 0}, 96),
                  make_tube("punch", kInner, kOuter, -kDepth - 6e-3, -kDepth, {0, 0}, 96),
                  make_tube("shoe", 17.5e-3, 19.5e-3, 0.3e-3, 12e-3, {26e-3, 0}, 4)};
  result.cavity.is_ring = true;
  result.cavity.inner_radius = kInner;
  result.cavity.outer_radius = kOuter;
  result.cavity.lower_corner = {-kOuter, -kOuter, -kDepth};
  result.cavity.upper_corner = {kOuter, kOuter, 0};
  result.cavity.volume = kPi * (kOuter * kOuter - kInner * kInner) * kDepth;
  result.cavity.narrowest_width = kOuter - kInner;
  result.maps = {make_map()};
  result.sections = {make_section()};
  results::Profile level{"fill level", "mm", "azimuth", "deg", {}, {}};
  for (int k = 0; k < 72; ++k) {
    level.x.push_back(2.5 + 5 * k);
    level.y.push_back(k == 20 ? kNone : surface_height(level.x.back()));
  }
  result.profiles = {level};
  return result;
}

}  // namespace diefill::render::test
