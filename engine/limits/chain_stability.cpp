#include "engine/limits/chain_stability.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "engine/limits/normal_springs.h"
#include "engine/observe/block_contacts.h"
#include "engine/observe/contact_forces.h"
#include "engine/powder/rigid_motion.h"

namespace diefill::engine {

namespace {

/// Translation and rotation of one grain, each times the root of its inertia; of unit forces and their
/// moments, over it (1/sqrt(kg)).
using Weighted = Eigen::Matrix<double, 6, 1>;

/// A contact as a term of the matrix of all grains: strength (q q^T) for the vector q that has `pull` at the
/// grain and `other_pull` at the other.
struct Term {
  std::size_t grain, other;  ///< places in the chain; kNoGrain: stands fast
  Weighted pull, other_pull;
  double strength;  ///< kg, k dt^2 / 4 + c dt
};

/// The terms of a chain's contacts.
class ChainTerms {
 public:
  ChainTerms(const Simulation& simulation, const std::vector<std::size_t>& grains) : simulation_(simulation) {
    for (std::size_t k = 0; k < grains.size(); ++k) place_[grains[k]] = k;
    for (const Block& block : simulation.neighbours().blocks())
      if (concerns(block)) take_in(block);
  }

  const std::vector<Term>& terms() const { return terms_; }

 private:
  bool concerns(const Block& block) const {
    const auto own = place_.lower_bound(block.begin);
    if (own != place_.end() && own->first < block.end) return true;
    return std::any_of(block.foreign.begin(), block.foreign.end(),
                       [&](std::uint32_t grain) { return place_.contains(grain); });
  }

  void take_in(const Block& block) {
    const SphereField& spheres = simulation_.spheres();
    visit_sphere_touches(simulation_, block, [&](const SphereTouch& touch) {
      const std::size_t grain = spheres.owner(touch.sphere), other = spheres.owner(touch.other);
      if (place_of(grain) == kNoGrain && place_of(other) == kNoGrain) return;
      const Eigen::Vector3d normal = eigen(touch.normal);
      add(touch.sphere, touch.other, normal,
          spring_between(simulation_, touch.sphere, touch.other, touch.overlap));
    });
    visit_tool_touches(simulation_, block, [&](const ToolTouch& touch) {
      const std::size_t grain = spheres.owner(touch.sphere);
      if (place_of(grain) == kNoGrain) return;
      add(touch.sphere, kNoGrain, touch.normal,
          spring_at_tool(simulation_, touch.sphere, touch.body, touch.overlap));
    });
  }

  void add(std::size_t sphere, std::size_t other_sphere, const Eigen::Vector3d& normal,
           const NormalSpring& spring) {
    const SphereField& spheres = simulation_.spheres();
    const double step = simulation_.settings().time_step;
    Term term;
    term.grain = place_of(spheres.owner(sphere));
    term.pull = pull_on(sphere, normal);
    term.other = other_sphere == kNoGrain ? kNoGrain : place_of(spheres.owner(other_sphere));
    if (term.other != kNoGrain) term.other_pull = pull_on(other_sphere, -normal);
    term.strength = 0.25 * spring.stiffness * step * step + spring.damping * step;
    terms_.push_back(term);
  }

  std::size_t place_of(std::size_t grain) const {
    const auto found = place_.find(grain);
    return found == place_.end() ? kNoGrain : found->second;
  }

  /// Of a unit force along `normal` through the sphere's centre.
  Weighted pull_on(std::size_t sphere, const Eigen::Vector3d& normal) const {
    const SphereField& spheres = simulation_.spheres();
    const std::size_t grain = spheres.owner(sphere);
    const GrainShape& shape = simulation_.shape_of(grain);
    Weighted pull = Weighted::Zero();
    pull.head<3>() = normal / std::sqrt(shape.mass);
    if (!shape.rotates || shape.spheres() == 1) return pull;
    const Rotation to_laboratory = rotation_of(plain(simulation_.grains().orientation_of(grain)));
    const Vector3 moment =
        cross(spheres.offset(grain, sphere % spheres.spheres_per_grain), to_laboratory.back(plain(normal)));
    pull.tail<3>() = eigen(moment).cwiseQuotient(shape.inertia.cwiseSqrt());
    return pull;
  }

  const Simulation& simulation_;
  std::map<std::size_t, std::size_t> place_;  ///< in the chain, of a grain
  std::vector<Term> terms_;
};

/// The matrix of all terms times `motion`.
std::vector<Weighted> applied(const std::vector<Term>& terms, const std::vector<Weighted>& motion) {
  std::vector<Weighted> result(motion.size(), Weighted::Zero());
  for (const Term& term : terms) {
    double along = 0;
    if (term.grain != kNoGrain) along += term.pull.dot(motion[term.grain]);
    if (term.other != kNoGrain) along += term.other_pull.dot(motion[term.other]);
    along *= term.strength;
    if (term.grain != kNoGrain) result[term.grain] += along * term.pull;
    if (term.other != kNoGrain) result[term.other] += along * term.other_pull;
  }
  return result;
}

double norm_of(const std::vector<Weighted>& motion) {
  double squared = 0;
  for (const Weighted& part : motion) squared += part.squaredNorm();
  return std::sqrt(squared);
}

}  // namespace

StabilityUse stability_used(const Simulation& simulation, const std::vector<std::size_t>& grains) {
  // Power iteration: no eigenvalue is negative, and the largest need not be known better than the step.
  constexpr int kIterations = 40;
  const ChainTerms chain(simulation, grains);
  std::vector<Weighted> motion(grains.size());
  // A start that no symmetry of a contact or grain is likely to have.
  for (std::size_t k = 0; k < motion.size(); ++k)
    for (int axis = 0; axis < 6; ++axis) motion[k][axis] = std::sin(1.0 + static_cast<double>(6 * k) + axis);
  StabilityUse use;
  for (int iteration = 0; iteration < kIterations; ++iteration) {
    const double length = norm_of(motion);
    if (length == 0) return {};
    for (Weighted& part : motion) part /= length;
    motion = applied(chain.terms(), motion);
    use.used = norm_of(motion);
  }
  const auto less = [](const Weighted& one, const Weighted& other) { return one.norm() < other.norm(); };
  use.grain =
      grains[static_cast<std::size_t>(std::max_element(motion.begin(), motion.end(), less) - motion.begin())];
  return use;
}

}  // namespace diefill::engine
