#include "engine/limits/normal_springs.h"

#include "engine/contact/pair_laws.h"
#include "engine/simulation/simulation.h"

namespace diefill::engine {

NormalSpring spring_between(const Simulation& simulation, std::size_t sphere, std::size_t other,
                            double overlap) {
  const SphereField& spheres = simulation.spheres();
  const auto law = law_between(simulation.types(), simulation.settings().contact, spheres.class_of(sphere),
                               spheres.class_of(other));
  return {law.stiffness(overlap), law.damping(overlap)};
}

NormalSpring spring_at_tool(const Simulation& simulation, std::size_t sphere, std::size_t body,
                            double overlap) {
  const WallBody& wall = simulation.bodies()[body];
  const auto law =
      law_at_wall(simulation.types(), simulation.settings().contact, simulation.spheres().class_of(sphere),
                  {wall.material(), wall.contact_radius(), wall.mirror()});
  // The image in a plane of symmetry comes as far as the grain does.
  const double approach = wall.mirror() ? 2 : 1;
  return {approach * law.stiffness(approach * overlap), approach * law.damping(approach * overlap)};
}

}  // namespace diefill::engine
