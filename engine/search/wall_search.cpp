// Near pairs of a block with walls.
#include <algorithm>
#include <cmath>

#include "engine/search/distance_rounding.h"
#include "engine/search/list_allowances.h"
#include "engine/search/neighbour_list.h"
#include "engine/walls/wall_clearance.h"

namespace diefill::engine {

namespace {

float rounded_down(double value) {
  return std::nextafter(static_cast<float>(value), 0.0F);
}

/// m, rounded down; of a plane 0.
float distance_of(const WallBody& body, std::uint32_t part, const Eigen::Vector3d& place) {
  if (body.flat()) return 0;
  const Eigen::Vector3d at =
      body.meshed() ? nearest_point(body.triangles()[part], place).point : body.centres()[part];
  return rounded_down((place - at).norm());
}

/// The parts of `body` no farther than `reach` (m) from `place` (m, body frame): wall spheres by rising
/// distance, planes and triangles in their own order.
void find_parts(const WallBody& body, const Eigen::Vector3d& place, double reach,
                std::vector<std::uint32_t>& found, std::vector<NearPart>& parts) {
  found.clear();
  parts.clear();
  body.find(place, reach, found);
  for (const std::uint32_t part : found) parts.push_back({distance_of(body, part, place), part});
  if (!body.flat() && !body.meshed()) std::sort(parts.begin(), parts.end());
}

/// A block's spheres, to leave out bodies that none of them is near.
struct BlockExtent {
  Eigen::AlignedBox3d box;  ///< m, of their centres
  double reach = 0;         ///< m, largest sum of a sphere's radius and how far its grain may move
};

BlockExtent extent_of(const Block& block, const SphereField& spheres, const ListReference& reference,
                      const NeighbourSettings& settings) {
  BlockExtent extent;
  const std::uint32_t first = block.begin * block.spheres_per_grain;
  for (std::uint32_t sphere = first; sphere < first + block.own_spheres(); ++sphere) {
    if (!spheres.exists(sphere)) continue;
    extent.box.extend(eigen(spheres.position(sphere)));
    extent.reach = std::max(extent.reach, radius_of(settings, spheres, sphere) +
                                              reference.allowance(sphere / block.spheres_per_grain));
  }
  return extent;
}

/// Whether none of the block's spheres can come to touch body b before the next search. `reach`: m, how far
/// from the centres of its spheres, its planes or its triangles a point may touch it.
bool is_far(const BlockExtent& extent, const WallBody& body, std::size_t b, const ListReference& reference,
            double reach) {
  if (extent.box.isEmpty()) return true;
  const double allowed = reach + farthest_allowance_of_body(reference, b);
  return clearance_of(body, reference.bodies[b], extent.box, kDistanceRounding * (extent.reach + allowed)) >
         0;
}

}  // namespace

void NeighbourList::find_wall_pairs(Block& block, const SphereField& spheres,
                                    const std::vector<WallBody>& bodies, const ListReference& reference,
                                    const ContactHistory& history, SearchWorkspace& workspace) const {
  const std::uint32_t per_grain = block.spheres_per_grain, own = block.own_spheres();
  std::vector<NearPart>& parts = workspace.near_parts;
  std::vector<std::uint32_t>& found = workspace.parts;
  found.clear();
  block.wall_first.assign(1, 0);
  block.wall_run_first.assign(1, 0);
  block.wall_runs.clear();
  block.wall_distance.clear();
  const BlockExtent extent = bodies.empty() ? BlockExtent() : extent_of(block, spheres, reference, settings_);
  for (std::uint32_t b = 0; b < bodies.size(); ++b) {
    const BodyMotion& pose = reference.bodies[b];
    const double reach = bodies[b].sphere_radius() + (bodies[b].mirror() ? settings_.law_range : 0);
    const std::uint32_t searched = is_far(extent, bodies[b], b, reference, reach) ? 0 : own;
    for (std::uint32_t k = 0; k < searched; ++k) {
      const std::uint32_t sphere = block.begin * per_grain + k, grain = sphere / per_grain;
      if (!spheres.exists(sphere)) continue;
      const Eigen::Vector3d place =
          pose.rotation.transpose() * (eigen(spheres.position(sphere)) - pose.translation);
      find_parts(bodies[b], place,
                 radius_of(settings_, spheres, sphere) + reach +
                     reference.allowance_of_body(b, reference.group_of(grain)) + reference.allowance(grain),
                 workspace.found, parts);
      if (parts.empty()) continue;
      block.wall_runs.push_back(
          {plain(place), static_cast<std::uint32_t>(found.size()), static_cast<LocalSphere>(k)});
      for (const NearPart& near : parts) {
        found.push_back(near.part);
        block.wall_distance.push_back(near.distance);
      }
    }
    block.wall_first.push_back(static_cast<std::uint32_t>(found.size()));
    block.wall_run_first.push_back(static_cast<std::uint32_t>(block.wall_runs.size()));
  }
  block.wall_runs.push_back({{}, static_cast<std::uint32_t>(found.size()), 0});
  fill_wall_table(block, found, history);
}

/// The table of the block's wall pairs with their histories; `parts`: of their bodies.
void NeighbourList::fill_wall_table(Block& block, const std::vector<std::uint32_t>& parts,
                                    const ContactHistory& history) const {
  block.wall_pairs.start(parts.size(), settings_.wall_history);
  for (std::size_t body = 0; body + 1 < block.wall_run_first.size(); ++body)
    for (std::uint32_t r = block.wall_run_first[body]; r < block.wall_run_first[body + 1]; ++r) {
      const LocalSphere own = block.wall_runs[r].own;
      for (std::uint32_t p = block.wall_runs[r].first; p < block.wall_runs[r + 1].first; ++p)
        block.wall_pairs.add({parts[p], own}, history.find(block.sphere(own), body_first_[body] + parts[p]),
                             nullptr);
    }
}

}  // namespace diefill::engine
