#include "process/laboratory/published/hu/cohesive_spheres.h"

#include <cmath>
#include <numbers>

#include "engine/laws/law_parameters.h"
#include "process/laboratory/published/lab_powder.h"

namespace diefill::process::laboratory {
namespace {

constexpr double kYoung = 1e7, kPoisson = 0.3, kFriction = 0.3;  // Pa

std::string pascal(double value) {
  return with_unit(value, "Pa");
}

double shear_modulus() {
  return engine::laws::contact_shear_modulus(kYoung, kPoisson, kYoung, kPoisson);
}

/// m, of the original sphere of mean mass.
double original_mean(const CohesiveSpheres& spheres) {
  double cubes = 0, shares = 0;
  for (const SphereClass& one : spheres.sizes) {
    cubes += one.share * std::pow(one.diameter, 3);
    shares += one.share;
  }
  return std::cbrt(cubes / shares);
}

std::string size_lines(const CohesiveSpheres& spheres) {
  if (spheres.sizes.size() == 1)
    return line("powder.grain_diameter", millimetres(spheres.enlargement * spheres.sizes.front().diameter));
  std::string classes;
  for (const SphereClass& one : spheres.sizes)
    classes += (classes.empty() ? "{ diameter = " : ", { diameter = ") +
               millimetres(spheres.enlargement * one.diameter) + ", share = " + plain(one.share) + " }";
  return line("powder.sizes",
              "{ distribution = \"classes\", basis = \"number\", classes = [" + classes + "] }");
}

std::string rolling_part(const CohesiveSpheres& spheres) {
  if (spheres.rolling == "none") return "{ law = \"none\" }";
  std::string part =
      "{ law = \"" + spheres.rolling + "\", rolling_friction = " + plain(spheres.rolling_friction);
  if (spheres.rolling == "EPSD2")
    part += ", shear_modulus = " + pascal(spheres.rolling_spring * shear_modulus());
  return part + " }";
}

}  // namespace

double largest_diameter(const CohesiveSpheres& spheres) {
  return spheres.enlargement * spheres.sizes.back().diameter;
}

std::string cohesive_lines(const CohesiveSpheres& spheres) {
  const double mean = original_mean(spheres);
  const double modulus = engine::laws::contact_modulus(kYoung, kPoisson, kYoung, kPoisson);
  std::string set = line("powder.sphere_radius", millimetres(0.5 * mean));
  set += line("powder.grain_mass",
              with_unit(kCohesiveDensity * std::numbers::pi / 6 * mean * mean * mean, "kg"));
  set += size_lines(spheres);
  set += line("contact.coarse_graining", "\"Hu chapter 5 method " + std::to_string(spheres.method) + '"');
  set += line("contact.normal", "{ law = \"JKR\", modulus = " + pascal(modulus) + ", surface_energy = \"" +
                                    plain(spheres.surface_energy) + " J/m^2\", load = \"" + spheres.load +
                                    "\" }");
  set +=
      line("contact.damping", "{ law = \"restitution\", restitution = " + plain(spheres.restitution) + " }");
  set += line("contact.friction", "{ law = \"Mindlin\", friction = " + plain(kFriction) +
                                      ", shear_modulus = " + pascal(shear_modulus()) + " }");
  set += line("contact.rolling", rolling_part(spheres));
  if (!spheres.load_rule.empty()) set += line("contact.load_rule", '"' + spheres.load_rule + '"');
  return set;
}

}  // namespace diefill::process::laboratory
