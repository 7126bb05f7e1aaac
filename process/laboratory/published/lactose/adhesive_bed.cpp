#include "process/laboratory/published/lactose/adhesive_bed.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "engine/powder/sphere_volume.h"
#include "engine/simulation/standard_gravity.h"
#include "process/laboratory/published/lab_powder.h"

namespace diefill::process::laboratory {
namespace {

constexpr double kDensity = 1545, kGravity = engine::kStandardGravity;  // kg/m^3, m/s^2
constexpr double kWallRatio = 30;                                       // k_1 of walls over that of grains
constexpr double kWallFriction = 0.2;
constexpr double kSmallestGap = 5e-9, kLargestGap = 1e-6;  // m
constexpr double kLattice = 1.6, kLoose = 0.5;             // d; solid fraction that `fill` is computed with
constexpr double kKept = 0.8;                              // share of the spheres that the cut leaves
constexpr double kAir = 1.8e-5;                            // Pa s
/// Spheres fly, then stick, for this long; they fall for as long as the lattice is high, and half as long.
constexpr double kFly = 3, kFall = 1.5;          // sqrt(d / g); over the time of falling
constexpr double kPulled = 3, kPullSpeed = 0.2;  // d, sqrt(g d)
constexpr double kSpeed = 5;                     // sqrt(g d), standard deviation of a component

/// Attraction of glued walls over that of spheres (Kottlan 2018, Eq. 34).
double glue_of(const AdhesivePowder& powder) {
  return 10 + 90 * (powder.radius - 5e-6) / 45e-6;
}

std::string attraction_part(const AdhesivePowder& powder, Packing packing, double times = 1) {
  const double range = packing == Packing::clusters ? kLargestGap : kSmallestGap;
  // The same law without attraction, so that its keys replace those of the scene.
  const double hamaker = packing == Packing::free ? 0 : times * powder.hamaker;
  return "{ law = \"van der Waals\", hamaker_constant = " + with_unit(hamaker, "J") +
         ", smallest_gap = " + with_unit(kSmallestGap, "m") + ", largest_gap = " + with_unit(range, "m") +
         " }";
}

/// d, of the powder that is poured, of which the cut takes the top.
double poured(const AdhesiveBed& bed) {
  return bed.fill / kKept;
}

/// d, of the lattice that the spheres begin in, in whole layers.
double lattice_height(const AdhesiveBed& bed) {
  const double grains = bed.width * bed.width * poured(bed) * kLoose * 6 / std::numbers::pi;
  const double across = std::floor(bed.width / kLattice);
  return std::ceil(grains / (across * across)) * kLattice;
}

std::string step_lines(const AdhesivePowder& powder, const AdhesiveBed& bed) {
  const double d = powder.diameter(), unit = std::sqrt(d / kGravity), height = lattice_height(bed);
  const bool waits = bed.packing == Packing::clusters || bed.packing == Packing::motion;
  std::string set = line("step.stir.random_velocity", with_unit(kSpeed * std::sqrt(kGravity * d), "m/s"));
  set += line("step.fly.duration", with_unit(kFly * unit, "s"));
  set += line("step.stick.at_rest", bed.packing == Packing::clusters ? "true" : "false");
  set += line("step.stick.contact", "{ attraction = " + attraction_part(powder, bed.packing) + " }");
  set += line("step.cluster.duration", with_unit((waits ? kFly : 0.01) * unit, "s"));
  double fall = std::sqrt(2 * height) * unit;
  // In air no faster than Stokes' terminal speed.
  if (bed.packing == Packing::slow)
    fall = std::max(fall, height * d * 18 * kAir / (kDensity * kGravity * d * d));
  set += line("step.fall.duration", with_unit(kFall * fall, "s"));
  set += line("step.cut.lowest", plain(kKept));
  return set;
}

}  // namespace

double AdhesivePowder::mass() const {
  return engine::sphere_mass(kDensity, radius);
}

double AdhesivePowder::loading_stiffness() const {
  return 4.0 / 3 * young * radius * std::sqrt(reference_overlap);
}

double AdhesivePowder::damping() const {
  const double ratio = std::numbers::pi / std::log(restitution);
  return std::sqrt(4 * 0.5 * mass() * loading_stiffness() / (1 + ratio * ratio));
}

AdhesivePowder lh100() {
  return {33.33e-19, 5.33, 0.7, 17e6, 0.0133, 66.67e-6, 0.1, 0.0667};
}

AdhesivePowder lh220() {
  return {50e-19, 12, 0.6, 21e6, 0.0267, 10e-6, 0.1, 0.2667};
}

std::string friction_part(const AdhesivePowder& powder, double friction) {
  return "{ law = \"Luding\", static_friction = " + plain(friction) +
         ", dynamic_friction = " + plain(powder.dynamic_ratio * friction) +
         ", stiffness = " + with_unit(powder.tangential_ratio * powder.loading_stiffness(), "N/m") +
         ", damping = " + with_unit(powder.damping_ratio * powder.damping(), "N s/m") + " }";
}

std::string powder_lines(const AdhesivePowder& powder, Packing packing) {
  const double k = powder.loading_stiffness();
  std::string set = line("powder.sphere_radius", with_unit(powder.radius, "m"));
  set += line("powder.grain_mass", with_unit(powder.mass(), "kg"));
  set += line("powder.grain_diameter", with_unit(powder.diameter(), "m"));
  if (packing == Packing::slow) set += line("powder.air_viscosity", with_unit(kAir, "Pa s"));
  set +=
      line("contact.normal", "{ law = \"Luding\", loading_stiffness = " + with_unit(k, "N/m") +
                                 ", unloading_stiffness = " + with_unit(powder.unloading_ratio * k, "N/m") +
                                 ", cohesion_stiffness = " +
                                 with_unit(packing == Packing::free ? 0 : powder.cohesion_ratio * k, "N/m") +
                                 ", plasticity_depth = " + plain(powder.depth) + " }");
  set += line("contact.damping",
              "{ law = \"linear restitution\", restitution = " + plain(powder.restitution) + " }");
  set += line("contact.friction", friction_part(powder, powder.friction));
  set += line("contact.rolling", std::string("{ law = \"") + powder.rolling_law +
                                     "\", rolling_friction = " + plain(powder.rolling) + " }");
  set += line("contact.attraction", attraction_part(powder, packing));
  set += line("contact.walls.normal",
              "{ law = \"linear\", stiffness = " + with_unit(kWallRatio * k, "N/m") + " }");
  set += line("contact.walls.friction", friction_part(powder, kWallFriction));
  return set;
}

std::string fine_wall_lines(const AdhesivePowder& powder, double width) {
  constexpr double kUsual = 1.5e-4, kAcross = 4;  // m, of [walls]; radii that a tool must measure
  return width < kAcross * kUsual ? line("walls.sphere_radius", with_unit(powder.radius, "m")) : "";
}

double plate_height(const AdhesiveBed& bed) {
  constexpr double kOutOfFlight = 40;  // d: no sphere flies up to the plate, where it would stick
  return lattice_height(bed) + kOutOfFlight;
}

std::string packed_bed_lines(const AdhesivePowder& powder, const AdhesiveBed& bed) {
  constexpr double kBlock = 2e-3;  // m, thickness of the plate
  const double d = powder.diameter(), half = 0.5 * bed.width * d;
  std::string set = powder_lines(powder, bed.packing) + step_lines(powder, bed);
  set += line("pour.from", point_in_millimetres(-half, -half, 0));
  set += line("pour.to", point_in_millimetres(half, half, poured(bed) * d));
  set += line("pour.fill_height", millimetres(poured(bed) * d));
  set += line("pour.solid_fraction", plain(kLoose));
  set += line("pour.lattice_constant", plain(kLattice));
  set += line("tool.plate.position", point_in_millimetres(0, 0, plate_height(bed) * d + kBlock));
  set +=
      line("numerics.periodic", "{ x = " + millimetres(2 * half) + ", y = " + millimetres(2 * half) + " }");
  set += line("measure.averaging_width", millimetres(d));
  return set;
}

std::string pressed_bed_lines(const AdhesivePowder& powder, const AdhesiveBed& bed, const Loads& loads) {
  // Down to above the loosest bed: LH220 with a solid fraction of 0.21 is 2.4 times as high as one of 0.5.
  constexpr double kAboveBed = 3;  // over the depth at 0.5
  const double d = powder.diameter(), top = plate_height(bed) * d,
               lowered = std::min(top, kAboveBed * bed.fill * d);
  const double area = bed.width * bed.width * d * d;
  std::string forces;
  for (const double stress : loads.stresses) {
    if (!forces.empty()) forces += ", ";
    forces += with_unit(stress * area, "N");
  }
  std::string set = packed_bed_lines(powder, bed);
  set += line("step.lower.distance", millimetres(top - lowered));
  set += line("step.press.forces", '[' + forces + ']');
  set += line("step.press.travel", millimetres(lowered - d));
  set += line("step.press.speed_limit", with_unit(loads.speed, "m/s"));
  set += line("step.press.pause", with_unit(loads.pause * std::sqrt(d / kGravity), "s"));
  set += line("probe.plate.interval", with_unit(loads.interval * std::sqrt(d / kGravity), "s"));
  set += line("step.pull.distance", millimetres(kPulled * d));
  set += line("step.pull.velocity", with_unit(kPullSpeed * std::sqrt(kGravity * d), "m/s"));
  // Glued, so that the bed breaks within and not at the plate or the floor.
  for (const char* tool : {"plate", "floor"})
    set += line(std::string("tool.") + tool + ".contact",
                "{ attraction = " + attraction_part(powder, bed.packing, glue_of(powder)) + " }");
  return set;
}

std::string unpressed_lines() {
  const std::string nothing = "{ kind = \"wait\", duration = \"1 us\" }";
  return line("step.lower", nothing) + line("step.press", nothing) + line("step.pull", nothing) +
         line("probe.plate.interval", "\"1 ms\"");
}

double surface_of(const results::PowderState& powder) {
  constexpr double kApart = 2;  // d, from a bed to spheres that stick to the plate above it
  std::vector<double> tops;
  for (std::size_t k = 0; k < powder.position.size(); ++k)
    tops.push_back(powder.position[k][2] + powder.sphere_radius_of(k));
  std::sort(tops.begin(), tops.end());
  const auto gap = std::adjacent_find(tops.begin(), tops.end(), [&](double lower, double upper) {
    return upper - lower > kApart * powder.grain_diameter;
  });
  if (gap != tops.end()) tops.erase(gap + 1, tops.end());
  const auto count =
      static_cast<std::ptrdiff_t>(std::min(tops.size(), std::max<std::size_t>(5, tops.size() / 100)));
  return std::accumulate(tops.end() - count, tops.end(), 0.0) / static_cast<double>(count);
}

}  // namespace diefill::process::laboratory
