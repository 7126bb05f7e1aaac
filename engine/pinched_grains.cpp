#include "engine/pinched_grains.h"

#include <algorithm>
#include <map>

#include "engine/grain_contacts.h"
#include "engine/mesh_contacts.h"

namespace diefill::engine {

namespace {

/// A contact deep enough to be part of a chain: between two grains, or of a grain with a tool.
struct DeepContact {
  std::size_t grain, other;  ///< `other`: a grain, or a body
  bool with_body;
  double overlap;  ///< over the smaller radius
};

/// m, of sphere `i` of `radius` (m) with a wall sphere, plane or triangle of `body`.
double wall_overlap(const Simulation& simulation, std::size_t body, std::uint32_t i, double radius,
                    std::uint32_t wall_part) {
  const WallBody& wall = simulation.bodies()[body];
  const BodyMotion& pose = simulation.body_motion(body);
  const Eigen::Vector3d place =
      pose.rotation.transpose() * (eigen(simulation.spheres().position(i)) - pose.translation);
  if (wall.meshed()) return radius - separation_from_triangle(wall, wall_part, place, radius).norm();
  if (!wall.flat()) return radius + wall.sphere_radius() - (place - wall.centres()[wall_part]).norm();
  const WallPlane& plane = wall.planes()[wall_part];
  return radius - plane.normal.dot(place - plane.point);
}

/// All contacts deeper than `threshold` (over the smaller radius), those among grains first, each in the
/// order of the blocks.
std::vector<DeepContact> deep_contacts(const Simulation& simulation, double threshold) {
  std::vector<DeepContact> deep;
  visit_grain_contacts(simulation, [&](std::size_t grain, std::size_t other, double overlap) {
    const double radius =
        std::min(simulation.shape_of(grain).sphere_radius, simulation.shape_of(other).sphere_radius);
    if (overlap > threshold * radius) deep.push_back({grain, other, false, overlap / radius});
  });
  const SphereField& spheres = simulation.spheres();
  for (const Block& block : simulation.neighbours().blocks())
    for (std::size_t body = 0; body + 1 < block.wall_first.size(); ++body)
      for (std::uint32_t p = block.wall_first[body]; p < block.wall_first[body + 1]; ++p) {
        if (!block.wall_pairs.touching[p]) continue;
        const WallPair& pair = block.wall_pairs.pair[p];
        const std::uint32_t i = block.sphere(pair.own);
        const std::size_t grain = spheres.owner(i);
        const double radius = simulation.shape_of(grain).sphere_radius;
        const double overlap = wall_overlap(simulation, body, i, radius, pair.wall);
        if (overlap > threshold * radius) deep.push_back({grain, body, true, overlap / radius});
      }
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
  std::size_t chain_of(std::size_t grain) const {
    while (parent_.at(grain) != grain) grain = parent_.at(grain);
    return grain;
  }

 private:
  std::map<std::size_t, std::size_t> parent_;
};

/// What is known of one chain.
struct Chain {
  std::vector<std::pair<std::size_t, std::size_t>> tools;  ///< body, and the grain that touches it
  std::map<std::size_t, double> load;                      ///< sum of a grain's deep overlaps
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

}  // namespace

std::vector<PinchedGrain> pinched_grains(const Simulation& simulation, double limit) {
  if (simulation.overlaps().any_over_radius() <= limit) return {};
  const auto contacts = deep_contacts(simulation, 0.5 * limit);
  const Chains chains(contacts);
  std::map<std::size_t, Chain> found;
  for (const auto& contact : contacts) {
    Chain& chain = found[chains.chain_of(contact.grain)];
    note(chain, contact.grain, contact.overlap);
    if (contact.with_body)
      chain.tools.emplace_back(contact.other, contact.grain);
    else
      note(chain, contact.other, contact.overlap);
  }
  std::vector<PinchedGrain> pinched;
  const Grains& grains = simulation.grains();
  for (const auto& [root, chain] : found) {
    if (!joins_moving_tools(chain, simulation)) continue;
    const auto less = [](const auto& one, const auto& other) { return one.second < other.second; };
    if (std::max_element(chain.deepest.begin(), chain.deepest.end(), less)->second <= limit) continue;
    const std::size_t k = std::max_element(chain.load.begin(), chain.load.end(), less)->first;
    pinched.push_back({grains.id[k], grains.position[k], chain.deepest.at(k)});
  }
  std::sort(pinched.begin(), pinched.end(),
            [](const PinchedGrain& one, const PinchedGrain& other) { return one.id < other.id; });
  return pinched;
}

}  // namespace diefill::engine
