#include "process/scene/contact/contact_parts.h"

#include "process/scene/contact/contact_key.h"
#include "process/scene/contact/luding_keys.h"

namespace diefill::process {
namespace {

using namespace engine::laws;

// Ranges span what is published by several powers of ten and end where the unit is more likely wrong.
constexpr ContactQuantity
    kModulus = {{Dimension::pressure, "5 MPa", "1e3 Pa", "1e12 Pa"}, "Pa"},
    kStiffness = {{Dimension::work_of_adhesion, "100 N/m", "1e-6 N/m", "1e9 N/m"}, "N/m"},
    kUnloading = {{Dimension::work_of_adhesion, "500 N/m", "1e-6 N/m", "1e9 N/m"}, "N/m"},
    kCohesion = {{Dimension::work_of_adhesion, "50 N/m", "0 N/m", "1e9 N/m"}, "N/m"},
    kSurfaceEnergy = {{Dimension::work_of_adhesion, "0.01 J/m^2", "0 J/m^2", "10 J/m^2"}, "J/m^2"},
    kDashpot = {{Dimension::mass_rate, "1e-3 N s/m", "0 N s/m", "1e6 N s/m"}, "N s/m"},
    kDamping = {{Dimension::damping_over_radius, "1e6 Pa s/m", "0 Pa s/m", "1e9 Pa s/m"}, "Pa s"},
    kTangential = {{Dimension::pressure, "1 MPa", "0 Pa", "1e12 Pa"}, "N/m"},
    kHamaker = {{Dimension::torque, "6.5e-20 J", "0 J", "1e-6 J"}, "J"},
    kGap = {{Dimension::length, "5 nm", "0 nm", "1 mm", true}, "m"},
    kPullOff = {{Dimension::force, "1e-6 N", "0 N", "1e3 N"}, "N"},
    kArm = {{Dimension::length, "0.375 mm", "0 mm", "100 mm"}, "m"},
    kTension = {{Dimension::work_of_adhesion, "0.072 N/m", "0 N/m", "10 N/m"}, "N/m"},
    kAngle = {{Dimension::angle, "30 deg", "0 deg", "90 deg"}, "rad"};
constexpr NumberRule kFriction = {0, 10, false, "0.5"};
constexpr NumberRule kRestitution = {0, 1, false, "0.5"};
constexpr NumberRule kRollingDamping = {0, 0.3, false, "0.3"};
constexpr NumberRule kRatio = {0, 1e3, true, "1"};
constexpr NumberRule kDepth = {0, 1, true, "0.05"};
constexpr NumberRule kPlasticity = {0, 0.99, false, "0.5"};
constexpr NumberRule kReferenceOverlap = {0, 0.5, true, "0.01"};
constexpr NumberRule kUnloadingRatio = {1, 1e3, true, "5"};
constexpr NumberRule kCohesionRatio = {0, 1e3, false, "0.1"};
constexpr NumberRule kLiquid = {0, 1, false, "0.05"};

/// The entry of a `Part`, with its keys.
template <class Parameters, class Part>
ContactPart<Parameters> entry(const std::string& name,
                              const std::vector<ContactKey<typename Part::Parameters>>& keys) {
  using Own = typename Part::Parameters;
  ContactPart<Parameters> part;
  part.name = name;
  part.example = "{ law = \"" + name + '"';
  for (const auto& key : keys)
    if (!key.example.empty()) part.example += ", " + key.name + " = " + key.example;
  part.example += " }";
  for (const auto& key : keys)
    if (!key.of_powder.empty()) part.of_powder.push_back(key.of_powder);
  part.read = [keys](TableReader& table, const PowderSpec& powder) {
    Own own;
    for (const auto& key : keys) key.read(table, powder, own);
    return Parameters(own);
  };
  part.description = [name, keys](const Parameters& parameters) {
    const Own* own = parameters.template of<Part>();
    std::string values;
    for (const auto& key : keys)
      if (const std::string shown = key.shown(*own); !shown.empty())
        values += (values.empty() ? " (" : ", ") + shown;
    return name + values + (values.empty() ? "" : ")");
  };
  return part;
}

template <class Part>
ContactPart<AnyNormal::Parameters> normal(const std::string& name,
                                          const std::vector<ContactKey<typename Part::Parameters>>& keys) {
  return entry<AnyNormal::Parameters, Part>(name, keys);
}
template <class Part>
ContactPart<AnyDamping::Parameters> damping(const std::string& name,
                                            const std::vector<ContactKey<typename Part::Parameters>>& keys) {
  return entry<AnyDamping::Parameters, Part>(name, keys);
}
template <class Part>
ContactPart<AnyFriction::Parameters> friction(
    const std::string& name, const std::vector<ContactKey<typename Part::Parameters>>& keys) {
  return entry<AnyFriction::Parameters, Part>(name, keys);
}
template <class Part>
ContactPart<AnyRolling::Parameters> rolling(const std::string& name,
                                            const std::vector<ContactKey<typename Part::Parameters>>& keys) {
  return entry<AnyRolling::Parameters, Part>(name, keys);
}
template <class Part>
ContactPart<AnyAttraction::Parameters> attraction(
    const std::string& name, const std::vector<ContactKey<typename Part::Parameters>>& keys) {
  return entry<AnyAttraction::Parameters, Part>(name, keys);
}

using Bierwisch = BierwischNormal::Parameters;
using Hertz = HertzMindlinNormal::Parameters;
using Jkr = JkrNormal::Parameters;
using Luding = LudingNormal::Parameters;
using Edinburgh = EdinburghNormal::Parameters;
using Cundall = CundallFriction::Parameters;
using Mindlin = MindlinFriction::Parameters;
using TwoFrictions = LudingFriction::Parameters;
using LudingRolls = LudingRolling::Parameters;
using Bridge = CapillaryBridge::Parameters;

const Choices<JkrLoad> kJkrLoads = {{"corrected", JkrLoad::corrected}, {"printed", JkrLoad::printed}};
const Choices<EdinburghBranch> kBranches = {{"Hertzian", EdinburghBranch::hertzian},
                                            {"linear", EdinburghBranch::linear}};
const Choices<SlipTest> kSlipTests = {{"spring and dashpot", SlipTest::spring_and_dashpot},
                                      {"spring alone", SlipTest::spring_alone}};

}  // namespace

const ContactParts<AnyNormal::Parameters>& normal_parts() {
  static const ContactParts<AnyNormal::Parameters> parts = {
      normal<BierwischNormal>(
          "Bierwisch", {quantity_of_powder("reduced_modulus", &Bierwisch::reduced_modulus, kModulus,
                                           &PowderSpec::reduced_modulus),
                        quantity_of_powder("work_of_adhesion", &Bierwisch::work_of_adhesion, kSurfaceEnergy,
                                           &PowderSpec::work_of_adhesion)}),
      normal<HertzMindlinNormal>("Hertz-Mindlin", {quantity_key("modulus", &Hertz::modulus, kModulus)}),
      normal<JkrNormal>("JKR", {quantity_key("modulus", &Jkr::modulus, kModulus),
                                quantity_key("surface_energy", &Jkr::surface_energy, kSurfaceEnergy),
                                choice_key("load", &Jkr::load, kJkrLoads)}),
      normal<LinearNormal>("linear",
                           {quantity_key("stiffness", &LinearNormal::Parameters::stiffness, kStiffness)}),
      normal<LudingNormal>(
          "Luding", {loading_or_modulus(quantity_key("loading_stiffness", &Luding::loading, kStiffness),
                                        kModulus.rule, kReferenceOverlap),
                     stiffness_or_ratio(quantity_key("unloading_stiffness", &Luding::unloading, kUnloading),
                                        "unloading_ratio", &Luding::unloading, kUnloadingRatio),
                     stiffness_or_ratio(
                         quantity_key("cohesion_stiffness", &Luding::cohesion, kCohesion, Need::optional),
                         "cohesion_ratio", &Luding::cohesion, kCohesionRatio),
                     number_key("plasticity_depth", &Luding::plasticity_depth, kDepth, Need::optional)}),
      normal<EdinburghNormal>(
          "Edinburgh",
          {choice_key("branch", &Edinburgh::branch, kBranches),
           key_where<Edinburgh>(&Edinburgh::is_hertzian,
                                quantity_key("modulus", &Edinburgh::modulus, kModulus),
                                "branch = \"linear\" takes `loading_stiffness` in N/m instead"),
           key_where<Edinburgh>(&Edinburgh::is_linear,
                                quantity_key("loading_stiffness", &Edinburgh::stiffness, kStiffness),
                                "branch = \"Hertzian\" takes `modulus` in Pa instead"),
           number_key("plasticity_ratio", &Edinburgh::plasticity_ratio, kPlasticity),
           quantity_key("surface_energy", &Edinburgh::surface_energy, kSurfaceEnergy),
           quantity_key("pull_off_force", &Edinburgh::pull_off, kPullOff, Need::optional)}),
  };
  return parts;
}

const ContactParts<AnyDamping::Parameters>& damping_parts() {
  static const ContactParts<AnyDamping::Parameters> parts = {
      damping<NoDamping>("none", {}),
      damping<BierwischDamping>(
          "Bierwisch", {quantity_of_powder("damping_over_radius", &BierwischDamping::Parameters::damping,
                                           kDamping, &PowderSpec::damping_over_radius, true)}),
      damping<RestitutionDamping>(
          "restitution",
          {number_key("restitution", &RestitutionDamping::Parameters::restitution, kRestitution)}),
      damping<ConstantDamping>(
          "constant", {quantity_key("coefficient", &ConstantDamping::Parameters::coefficient, kDashpot)}),
      damping<LinearRestitutionDamping>(
          "linear restitution",
          {number_key("restitution", &LinearRestitutionDamping::Parameters::restitution, kRestitution)}),
  };
  return parts;
}

const ContactParts<AnyFriction::Parameters>& friction_parts() {
  static const ContactParts<AnyFriction::Parameters> parts = {
      friction<FreeSliding>("none", {}),
      friction<CundallFriction>(
          "Bierwisch", {number_of_powder("friction", &Cundall::friction, kFriction, &PowderSpec::friction),
                        quantity_of_powder("tangential_over_radius", &Cundall::tangential, kTangential,
                                           &PowderSpec::tangential_over_radius, true),
                        flag_key("cut_back", &Cundall::cut_back)}),
      friction<MindlinFriction>("Mindlin",
                                {number_key("friction", &Mindlin::friction, kFriction),
                                 quantity_key("shear_modulus", &Mindlin::shear_modulus, kModulus),
                                 number_key("restitution", &Mindlin::restitution, kRestitution, Need::linked),
                                 choice_key("slip_test", &Mindlin::slip_test, kSlipTests)}),
      friction<LudingFriction>("Luding",
                               {number_key("static_friction", &TwoFrictions::static_friction, kFriction),
                                number_key("dynamic_friction", &TwoFrictions::dynamic_friction, kFriction),
                                quantity_key("stiffness", &TwoFrictions::stiffness, kStiffness),
                                quantity_key("damping", &TwoFrictions::damping, kDashpot, Need::optional),
                                flag_key("slip_memory", &TwoFrictions::slip_memory)}),
  };
  return parts;
}

const ContactParts<AnyRolling::Parameters>& rolling_parts() {
  static const ContactParts<AnyRolling::Parameters> parts = {
      rolling<FreeRolling>("none", {}),
      rolling<LoadRolling>(
          "CDT", {number_key("rolling_friction", &LoadRolling::Parameters::rolling_friction, kFriction)}),
      rolling<ElasticRolling>(
          "elastic CDT",
          {number_key("rolling_friction", &ElasticRolling::Parameters::rolling_friction, kFriction),
           flag_key("harmonic_mean", &ElasticRolling::Parameters::harmonic_mean)}),
      rolling<Epsd2Rolling>(
          "EPSD2",
          {number_key("rolling_friction", &Epsd2Rolling::Parameters::rolling_friction, kFriction),
           quantity_key("shear_modulus", &Epsd2Rolling::Parameters::shear_modulus, kModulus, Need::linked)}),
      rolling<LudingRolling>(
          "Luding",
          {number_key("rolling_friction", &LudingRolls::rolling_friction, kFriction),
           quantity_key("tangential_stiffness", &LudingRolls::tangential_stiffness, kStiffness, Need::linked),
           number_key("stiffness_ratio", &LudingRolls::stiffness_ratio, kRatio, Need::optional),
           number_key("damping_ratio", &LudingRolls::damping_ratio, kRollingDamping, Need::optional)}),
      rolling<OwnSpinRolling>("Bierwisch",
                              {quantity_of_powder("rolling_friction", &OwnSpinRolling::Parameters::arm, kArm,
                                                  &PowderSpec::rolling_friction)}),
  };
  return parts;
}

const ContactParts<AnyAttraction::Parameters>& attraction_parts() {
  static const ContactParts<AnyAttraction::Parameters> parts = {
      attraction<NoAttraction>("none", {}),
      attraction<VanDerWaals>(
          "van der Waals",
          {quantity_key("hamaker_constant", &VanDerWaals::Parameters::hamaker, kHamaker),
           quantity_key("smallest_gap", &VanDerWaals::Parameters::smallest_gap, kGap, Need::optional),
           quantity_key("largest_gap", &VanDerWaals::Parameters::largest_gap, kGap, Need::optional),
           flag_key("harmonic_mean", &VanDerWaals::Parameters::harmonic_mean)}),
      attraction<CapillaryBridge>(
          "capillary", {quantity_key("surface_tension", &Bridge::surface_tension, kTension),
                        quantity_key("contact_angle", &Bridge::contact_angle, kAngle, Need::optional),
                        number_key("liquid_fraction", &Bridge::liquid_fraction, kLiquid, Need::optional),
                        number_key("bridge_share", &Bridge::bridge_share, kLiquid, Need::optional),
                        quantity_key("smallest_gap", &Bridge::smallest_gap, kGap, Need::optional)}),
  };
  return parts;
}

}  // namespace diefill::process
