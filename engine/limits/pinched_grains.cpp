#include "engine/limits/pinched_grains.h"

#include <algorithm>
#include <map>

#include "engine/limits/chain_stability.h"
#include "engine/observe/block_contacts.h"

namespace diefill::engine {

namespace {

/// Over the limit: how deep the contacts are that join tools through a chain beyond it, and those of a chain
/// that is pressed less deeply but at many places.
constexpr double kDeep = 0.5, kShallow = 0.25;

/// Grains of the largest chain that counts as a jam. A longer chain is a bed under load: if the time step is
/// unstable for it, removing single grains does not help.
constexpr std::size_t kLargestJam = 64;

/// A contact deep enough to be part of a chain: between two grains, or of a grain with a tool.
struct DeepContact {
  std::size_t grain, other;  ///< `other`: a grain, or a body
  bool with_body;
  double overlap;  ///< over the smaller radius
};

/// Of one block: appended.
void find_deep_contacts(const Simulation& simulation, const Block& block, double threshold,
                        std::vector<DeepContact>& deep) {
  const SphereField& spheres = simulation.spheres();
  const auto radius_of = [&](std::size_t grain) { return simulation.shape_of(grain).sphere_radius; };
  visit_sphere_touches(simulation, block, [&](const SphereTouch& touch) {
    const std::size_t grain = spheres.owner(touch.sphere), other = spheres.owner(touch.other);
    const double overlap = touch.overlap / std::min(radius_of(grain), radius_of(other));
    if (overlap > threshold) deep.push_back({grain, other, false, overlap});
  });
  visit_tool_touches(simulation, block, [&](const ToolTouch& touch) {
    const std::size_t grain = spheres.owner(touch.sphere);
    const double overlap = touch.overlap / radius_of(grain);
    if (overlap > threshold) deep.push_back({grain, touch.body, true, overlap});
  });
}

/// All contacts deeper than `threshold` (over the smaller radius), in the order of the blocks.
std::vector<DeepContact> deep_contacts(const Simulation& simulation, double threshold) {
  std::vector<DeepContact> deep;
  const auto& blocks = simulation.neighbours().blocks();
  for (std::size_t b = 0; b < blocks.size(); ++b)
    if (simulation.state().tallies[b].overlap.any_over_radius() > threshold)
      find_deep_contacts(simulation, blocks[b], threshold, deep);
  return deep;
}

/// Grains of deep contacts, joined into chains.
class Chains {
 public:
  explicit Chains(const std::vector<DeepContact>& contacts) {
    for (const auto& contact : contacts) {
      parent_.try_emplace(contact.grain, contact.grain);
      if (!contact.with_body) parent_.try_emplace(contact.other, contact.other);
    }
    for (const auto& contact : contacts)
      if (!contact.with_body) parent_[chain_of(contact.grain)] = chain_of(contact.other);
  }
  std::size_t chain_of(std::size_t grain) {
    while (parent_.at(grain) != grain) grain = parent_.at(grain) = parent_.at(parent_.at(grain));
    return grain;
  }

 private:
  std::map<std::size_t, std::size_t> parent_;
};

/// What is known of one chain.
struct Chain {
  /// Body, and the grain that touches it. A plane of symmetry is none: in the whole model the chain goes on
  /// to its own image, and so ends on the same tools.
  std::vector<std::pair<std::size_t, std::size_t>> tools;
  std::map<std::size_t, double> load;  ///< sum of a grain's deep overlaps
  std::map<std::size_t, double> deepest;
};

void note(Chain& chain, std::size_t grain, double overlap) {
  chain.load[grain] += overlap;
  chain.deepest[grain] = std::max(chain.deepest[grain], overlap);
}

/// Whether bodies a and b move against each other at `place` (m); tools shaken together do not.
bool move_apart(const Simulation& simulation, std::size_t a, std::size_t b, const Eigen::Vector3d& place) {
  constexpr double kRounding = 1e-6;
  const Eigen::Vector3d one = simulation.body_motion(a).velocity_at(place);
  const Eigen::Vector3d other = simulation.body_motion(b).velocity_at(place);
  return (one - other).norm() > kRounding * (one.norm() + other.norm());
}

bool joins_moving_tools(const Chain& chain, const Simulation& simulation) {
  if (chain.tools.empty()) return false;
  const std::size_t first = chain.tools.front().first;
  return std::any_of(chain.tools.begin(), chain.tools.end(), [&](const auto& tool) {
    return move_apart(simulation, first, tool.first, simulation.grains().position[tool.second]);
  });
}

/// The grain for which `amount` is largest, and how much that is.
std::pair<std::size_t, double> largest(const std::map<std::size_t, double>& amount) {
  const auto less = [](const auto& one, const auto& other) { return one.second < other.second; };
  return *std::max_element(amount.begin(), amount.end(), less);
}

/// Chains of contacts deeper than `threshold`, by their first grain.
std::map<std::size_t, Chain> chains_of(const Simulation& simulation, double threshold) {
  const auto contacts = deep_contacts(simulation, threshold);
  Chains chains(contacts);
  std::map<std::size_t, Chain> found;
  for (const auto& contact : contacts) {
    Chain& chain = found[chains.chain_of(contact.grain)];
    note(chain, contact.grain, contact.overlap);
    if (!contact.with_body)
      note(chain, contact.other, contact.overlap);
    else if (!simulation.bodies()[contact.other].mirror())
      chain.tools.emplace_back(contact.other, contact.grain);
  }
  return found;
}

/// Grains to remove, each once.
class GrainsToRemove {
 public:
  explicit GrainsToRemove(const Simulation& simulation) : simulation_(simulation) {}

  void add(std::size_t grain, double deepest) {
    const Grains& grains = simulation_.grains();
    pinched_.try_emplace(grains.id[grain], PinchedGrain{grains.id[grain], grains.position[grain], deepest});
  }
  bool holds(std::size_t grain) const { return pinched_.count(simulation_.grains().id[grain]) > 0; }
  std::vector<PinchedGrain> by_id() const {
    std::vector<PinchedGrain> all;
    for (const auto& [id, grain] : pinched_) all.push_back(grain);
    return all;
  }

 private:
  const Simulation& simulation_;
  std::map<std::uint64_t, PinchedGrain> pinched_;
};

/// Of every chain beyond `limit` the most deeply pressed grain: the force laws are not valid for it any more.
void remove_deepest(const Simulation& simulation, double limit, GrainsToRemove& to_remove) {
  for (const auto& [root, chain] : chains_of(simulation, kDeep * limit)) {
    if (!joins_moving_tools(chain, simulation) || largest(chain.deepest).second <= limit) continue;
    const std::size_t grain = largest(chain.load).first;
    to_remove.add(grain, chain.deepest.at(grain));
  }
}

/// Of every chain for which the time step is unstable the grain of largest amplitude, unless a grain of the
/// chain has been chosen already.
void remove_unstable(const Simulation& simulation, double limit, GrainsToRemove& to_remove) {
  for (const auto& [root, chain] : chains_of(simulation, kShallow * limit)) {
    if (chain.load.size() > kLargestJam || !joins_moving_tools(chain, simulation)) continue;
    std::vector<std::size_t> grains;
    for (const auto& [grain, load] : chain.load) grains.push_back(grain);
    if (std::any_of(grains.begin(), grains.end(), [&](std::size_t k) { return to_remove.holds(k); }))
      continue;
    const StabilityUse use = stability_used(simulation, grains);
    if (use.used >= 1) to_remove.add(use.grain, chain.deepest.at(use.grain));
  }
}

}  // namespace

std::vector<PinchedGrain> pinched_grains(const Simulation& simulation, double limit) {
  const double deepest = simulation.overlaps().any_over_radius();
  GrainsToRemove to_remove(simulation);
  if (deepest > limit) remove_deepest(simulation, limit, to_remove);
  if (deepest > kShallow * limit) remove_unstable(simulation, limit, to_remove);
  return to_remove.by_id();
}

}  // namespace diefill::engine
