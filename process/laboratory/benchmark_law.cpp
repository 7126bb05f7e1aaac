#include "process/laboratory/benchmark_law.h"

#include <stdexcept>

#include "engine/laws/law_parameters.h"

namespace diefill::process::laboratory {

namespace {

using namespace engine::laws;

constexpr double kModulus = 1e7, kPoisson = 0.3;                           // Pa, E* of a pair
constexpr double kRestitution = 0.5, kFriction = 0.5;                      //
constexpr double kSurfaceEnergy = 0.005;                                   // J/m^2
constexpr double kYoung = 2 * (1 - kPoisson * kPoisson) * kModulus;        // Pa, of one material
constexpr double kShear = kYoung / (4 * (1 + kPoisson) * (2 - kPoisson));  // Pa, G* of a pair

LawParameters hertz_mindlin() {
  LawParameters law;
  law.normal = HertzMindlinNormal::Parameters{.modulus = kModulus};
  law.damping = RestitutionDamping::Parameters{.restitution = kRestitution, .modulus = kModulus};
  law.friction = MindlinFriction::Parameters{
      .shear_modulus = kShear, .friction = kFriction, .restitution = kRestitution};
  return law;
}

}  // namespace

const std::vector<std::string>& benchmark_laws() {
  static const std::vector<std::string> names = {"bierwisch", "hertz-mindlin", "jkr"};
  return names;
}

void set_benchmark_law(BenchmarkBedState& bed, const std::string& name) {
  if (name == "bierwisch") return;
  const LawParameters floor = hertz_mindlin();
  LawParameters law = floor;
  if (name == "jkr")
    law.normal = JkrNormal::Parameters{.modulus = kModulus, .surface_energy = kSurfaceEnergy};
  else if (name != "hertz-mindlin")
    throw std::invalid_argument("no benchmark law is called '" + name + "'");
  bed.settings.contact = engine::one_powder(law, floor);
}

}  // namespace diefill::process::laboratory
