#include "engine/neighbour_list.h"

#include <algorithm>
#include <numeric>

namespace diefill::engine {

namespace {

/// Spheres of a block: enough that few pairs cross its border, few enough that threads share the work evenly
/// and that the block's spheres and sums stay in the second-level cache. Block borders depend on the number
/// of grains only.
constexpr std::size_t kSpheresPerBlock = 1024;

}  // namespace

NeighbourList::NeighbourList(const NeighbourSettings& settings, std::vector<std::uint32_t> body_first)
    : settings_(settings), body_first_(std::move(body_first)) {}

void NeighbourList::build(const SphereField& spheres, const std::vector<WallBody>& bodies,
                          const ListReference& reference, const ContactHistory& history,
                          const ContactHistory& wall_history, Workers& workers) {
  const double reach = 2 * settings_.sphere_radius + settings_.law_range + reference.skin;
  cells_.build(spheres.position, reach);
  cut_into_blocks(spheres.grains, kSpheresPerBlock / spheres.spheres_per_grain + 1);
  workers.for_each(blocks_.size(), [&](std::size_t b) {
    Block& block = blocks_[b];
    block.reference = reference.position[(block.begin + block.end) / 2];
    find_grain_pairs(block, spheres, reach, history);
    find_wall_pairs(block, spheres, bodies, reference, wall_history);
    block.sums.resize(block.grains() + block.foreign.size());
  });
  index_foreign_sums();
}

std::size_t NeighbourList::near_pairs() const {
  std::size_t pairs = 0;
  for (const auto& block : blocks_) pairs += block.grain_pairs.size();
  return pairs;
}

void NeighbourList::cut_into_blocks(std::size_t grains, std::size_t grains_per_block) {
  const std::size_t count = (grains + grains_per_block - 1) / grains_per_block;
  blocks_.resize(count);
  for (std::size_t b = 0; b < count; ++b) {
    blocks_[b].begin = static_cast<std::uint32_t>(grains * b / count);
    blocks_[b].end = static_cast<std::uint32_t>(grains * (b + 1) / count);
  }
}

std::uint32_t NeighbourList::slot_for(Block& block, const SphereField& spheres, std::uint32_t grain,
                                      std::vector<std::uint32_t>& slot_of) const {
  if (grain >= block.begin && grain < block.end) return grain - block.begin;
  if (slot_of[grain] == kGone) {
    slot_of[grain] = static_cast<std::uint32_t>(block.grains() + block.foreign.size());
    const bool real = grain < spheres.grains;
    const std::uint32_t owner = real ? grain : spheres.images[grain - spheres.grains].owner;
    block.foreign.push_back(
        {owner, real ? Eigen::Vector3d::Zero() : spheres.images[grain - spheres.grains].shift});
  }
  return slot_of[grain];
}

void NeighbourList::find_grain_pairs(Block& block, const SphereField& spheres, double reach,
                                     const ContactHistory& history) const {
  const auto per_grain = static_cast<std::uint32_t>(spheres.spheres_per_grain);
  const auto grains = static_cast<std::uint32_t>(spheres.grains);
  block.grain_pairs.clear();
  block.grain_pairs.width = settings_.grain_memory;
  block.foreign.clear();
  // Kept between blocks and handed back clean: a table of all grains for every block would cost the square of
  // their number.
  thread_local std::vector<std::uint32_t> slot_of, touched;
  slot_of.resize(std::max(slot_of.size(), spheres.size() / per_grain), kGone);
  touched.clear();

  for (std::uint32_t i = block.begin * per_grain; i < block.end * per_grain; ++i) {
    const Vector3 here = spheres.position[i];
    const std::uint32_t own_grain = i / per_grain;
    cells_.visit_neighbourhood(here, [&](std::uint32_t j, Vector3 there) {
      const Vector3 between = there - here;
      if (dot(between, between) >= reach * reach) return;
      const std::uint32_t grain = j / per_grain;
      const std::uint32_t owner = grain < grains ? grain : spheres.images[grain - grains].owner;
      // Every pair once, by the grain that comes first; an image stands for its owner.
      if (owner <= own_grain) return;
      if (grain >= block.end) touched.push_back(grain);
      block.grain_pairs.add({i, j, own_grain - block.begin, slot_for(block, spheres, grain, slot_of)},
                            history.find(i, owner * per_grain + j % per_grain));
    });
  }
  for (const std::uint32_t grain : touched) slot_of[grain] = kGone;
}

void NeighbourList::find_wall_pairs(Block& block, const SphereField& spheres,
                                    const std::vector<WallBody>& bodies, const ListReference& reference,
                                    const ContactHistory& history) const {
  const auto per_grain = static_cast<std::uint32_t>(spheres.spheres_per_grain);
  block.wall_pairs.clear();
  block.wall_pairs.width = settings_.wall_memory;
  block.wall_first.assign(1, 0);
  std::vector<std::uint32_t> found;
  for (std::uint32_t b = 0; b < bodies.size(); ++b) {
    const BodyMotion& pose = reference.bodies[b];
    const double reach = settings_.sphere_radius + bodies[b].sphere_radius() + reference.skin;
    for (std::uint32_t i = block.begin * per_grain; i < block.end * per_grain; ++i) {
      found.clear();
      bodies[b].find(pose.rotation.transpose() * (eigen(spheres.position[i]) - pose.translation), reach,
                     found);
      for (const std::uint32_t w : found)
        block.wall_pairs.add({i, w, i / per_grain - block.begin}, history.find(i, body_first_[b] + w));
    }
    block.wall_first.push_back(static_cast<std::uint32_t>(block.wall_pairs.size()));
  }
}

void NeighbourList::index_foreign_sums() {
  const auto home = [&](std::uint32_t grain) {
    const auto after = std::upper_bound(blocks_.begin(), blocks_.end(), grain,
                                        [](std::uint32_t g, const Block& block) { return g < block.end; });
    return static_cast<std::size_t>(after - blocks_.begin());
  };
  foreign_first_.assign(blocks_.size() + 1, 0);
  for (const auto& block : blocks_)
    for (const auto& foreign : block.foreign) ++foreign_first_[home(foreign.owner) + 1];
  std::partial_sum(foreign_first_.begin(), foreign_first_.end(), foreign_first_.begin());
  foreign_sums_.resize(foreign_first_.back());
  std::vector<std::uint32_t> next(foreign_first_.begin(), foreign_first_.end() - 1);
  for (std::uint32_t b = 0; b < blocks_.size(); ++b)
    for (std::uint32_t k = 0; k < blocks_[b].foreign.size(); ++k) {
      const std::uint32_t grain = blocks_[b].foreign[k].owner;
      foreign_sums_[next[home(grain)]++] = {grain, b, blocks_[b].grains() + k};
    }
}

}  // namespace diefill::engine
