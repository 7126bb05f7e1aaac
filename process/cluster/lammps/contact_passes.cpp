// Selects the contact pass for a model: laws are chosen as in the built-in engine's loops, so that pairs
// store the same contact history.
#include "engine/simulation/simulation_parts.h"
#include "process/cluster/lammps/grain_pass.h"
#include "process/cluster/lammps/wall_pass.h"

namespace diefill::process::cluster {

namespace {

using engine::LeverArm;
namespace laws = engine::laws;

/// Calls use(law) with the type of Bierwisch's law. All its terms are included, with zero coefficients where
/// the model does not use them: fewer types to compile than in the engine's own loops, the same forces.
template <class Use>
auto with_bierwisch(engine::SpringLimit limit, const Use& use) {
  using laws::ContactLaw, laws::HertzianCohesion, laws::TangentialSpring;
  if (limit == engine::SpringLimit::cut_back)
    return use(std::type_identity<ContactLaw<HertzianCohesion, TangentialSpring<true>>>{});
  return use(std::type_identity<ContactLaw<HertzianCohesion, TangentialSpring<false>>>{});
}

template <class Pairs, LeverArm kArm, bool kClumps>
std::unique_ptr<ContactPass> pass_over(Pairs pairs, const PowderModel& model) {
  return std::make_unique<GrainPass<Pairs, kArm, kClumps>>(std::move(pairs), model);
}

/// Bierwisch's law for each body; empty if any body has a different law.
std::vector<laws::BierwischLaw> bierwisch_at_walls(const PowderModel& model) {
  std::vector<laws::BierwischLaw> found;
  for (const auto& body : model.bodies) {
    const auto law = engine::tuned_law(model.types, model.settings.contact,
                                       body.mirror() ? model.types.material(0) : body.material());
    if (!law || (!found.empty() && law->spring_limit != found.front().spring_limit)) return {};
    found.push_back(*law);
  }
  return found;
}

}  // namespace

std::unique_ptr<ContactPass> make_grain_pass(const PowderModel& model) {
  const engine::ParticleTypes& types = model.types;
  const auto& settings = model.settings;
  const double radius = types.shape(0).sphere_radius;
  const auto tuned = engine::tuned_law(types, settings.contact, types.material(0));
  return engine::with_arm(
      settings.lever_arm, types.clumps(),
      [&]<class Arm, class Clumps>(Arm, Clumps) -> std::unique_ptr<ContactPass> {
        constexpr LeverArm kArm = Arm::value;
        constexpr bool kClumps = Clumps::value;
        if (tuned)
          return with_bierwisch(tuned->spring_limit, [&]<class Law>(std::type_identity<Law>) {
            return pass_over<engine::MonodispersePairs<Law>, kArm, kClumps>(
                {Law(tuned->parameters, engine::effective_radius(radius, radius)), radius}, model);
          });
        return pass_over<engine::ClassPairs, kArm, kClumps>({types, settings.contact}, model);
      });
}

std::unique_ptr<ContactPass> make_wall_pass(const PowderModel& model) {
  const engine::ParticleTypes& types = model.types;
  const auto surfaces = engine::surfaces_of(model.bodies);
  const auto tuned = bierwisch_at_walls(model);
  return engine::with_arm(
      model.settings.lever_arm, types.clumps(),
      [&]<class Arm, class Clumps>(Arm, Clumps) -> std::unique_ptr<ContactPass> {
        if (!tuned.empty())
          return with_bierwisch(tuned.front().spring_limit, [&]<class Law>(std::type_identity<Law>) {
            const double radius = types.shape(0).sphere_radius;
            std::vector<Law> laws;
            for (std::size_t b = 0; b < surfaces.size(); ++b)
              laws.emplace_back(
                  tuned[b].parameters,
                  engine::effective_radius(radius, surfaces[b].mirror ? radius : surfaces[b].radius));
            return std::unique_ptr<ContactPass>(
                std::make_unique<WallPass<Law, Arm::value, Clumps::value>>(std::move(laws), model));
          });
        std::vector<laws::GeneralContactLaw> laws;
        for (const auto& surface : surfaces)
          for (std::size_t own = 0; own < types.classes().size(); ++own)
            laws.push_back(engine::law_at_wall(types, model.settings.contact,
                                               static_cast<engine::ClassNumber>(own), surface));
        return std::make_unique<WallPass<laws::GeneralContactLaw, Arm::value, Clumps::value>>(std::move(laws),
                                                                                              model);
      });
}

}  // namespace diefill::process::cluster
