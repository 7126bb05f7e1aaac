#include "process/laboratory/bulk_density/sticky_spheres.h"

#include <numbers>

namespace diefill::process::laboratory {

namespace laws = engine::laws;

namespace {

constexpr double kYoung = 1e7, kPoisson = 0.3, kRestitution = 0.1, kFriction = 0.3;

}  // namespace

double sticky_modulus() {
  return laws::contact_modulus(kYoung, kPoisson, kYoung, kPoisson);
}

double sticky_shear_modulus() {
  return laws::contact_shear_modulus(kYoung, kPoisson, kYoung, kPoisson);
}

laws::LawParameters sticky_law(double surface_energy, laws::JkrLoad load,
                               const laws::AnyRolling::Parameters& rolling) {
  laws::LawParameters law;
  law.normal = laws::JkrNormal::Parameters{sticky_modulus(), surface_energy, load};
  law.damping = laws::RestitutionDamping::Parameters{kRestitution, sticky_modulus()};
  law.friction = laws::MindlinFriction::Parameters{
      .shear_modulus = sticky_shear_modulus(), .friction = kFriction, .restitution = kRestitution};
  law.rolling = rolling;
  law.load_rule = laws::LoadRule::without;
  laws::require_sensible(law);
  return law;
}

engine::GrainShape sticky_sphere(double radius) {
  return engine::model_b(radius, kStickyDensity * 4.0 / 3.0 * std::numbers::pi * radius * radius * radius);
}

engine::WallBodySpec plane_floor() {
  engine::WallBodySpec floor;
  floor.name = "floor";
  floor.planes = {{Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitZ()}};
  return floor;
}

}  // namespace diefill::process::laboratory
