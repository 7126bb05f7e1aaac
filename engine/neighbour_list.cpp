#include "engine/neighbour_list.h"

#include <algorithm>
#include <numeric>

namespace diefill::engine {

namespace {

/// Grains of a block: enough that few pairs cross its border, few enough that two threads share the work
/// evenly. Block borders depend on the number of grains only.
constexpr std::size_t kGrainsPerBlock = 256;

}  // namespace

NeighbourList::NeighbourList(const NeighbourSettings& settings, std::vector<std::uint32_t> body_first)
    : settings_(settings), body_first_(std::move(body_first)) {}

void NeighbourList::build(const SphereField& spheres, const std::vector<WallBody>& bodies,
                          const std::vector<BodyMotion>& poses, const ContactHistory& history,
                          const ContactHistory& wall_history, Workers& workers) {
  cells_.build(spheres.position, 2 * settings_.sphere_radius + settings_.skin);
  cut_into_blocks(spheres.grains);
  workers.for_each(blocks_.size(), [&](std::size_t b) {
    find_grain_pairs(blocks_[b], spheres, history);
    find_wall_pairs(blocks_[b], spheres, bodies, poses, wall_history);
    blocks_[b].sums.resize(blocks_[b].grains() + blocks_[b].foreign.size());
  });
  index_foreign_sums(spheres.grains);
}

void NeighbourList::cut_into_blocks(std::size_t grains) {
  const std::size_t count = (grains + kGrainsPerBlock - 1) / kGrainsPerBlock;
  blocks_.resize(count);
  for (std::size_t b = 0; b < count; ++b) {
    blocks_[b].begin = static_cast<std::uint32_t>(grains * b / count);
    blocks_[b].end = static_cast<std::uint32_t>(grains * (b + 1) / count);
  }
}

void NeighbourList::find_grain_pairs(Block& block, const SphereField& spheres,
                                     const ContactHistory& history) const {
  const auto per_grain = static_cast<std::uint32_t>(spheres.spheres_per_grain);
  const auto grains = static_cast<std::uint32_t>(spheres.grains);
  const double reach = 2 * settings_.sphere_radius + settings_.skin;
  block.grain_pairs.clear();
  block.foreign.clear();
  // Kept between blocks and handed back clean: a table of all grains for every block would cost the square of
  // their number.
  thread_local std::vector<std::uint32_t> slot_of;
  if (slot_of.size() < grains) slot_of.resize(grains, kGone);

  const auto slot_for = [&](std::uint32_t owner) {
    if (owner < block.end) return owner - block.begin;
    if (slot_of[owner] == kGone) {
      slot_of[owner] = block.grains() + static_cast<std::uint32_t>(block.foreign.size());
      block.foreign.push_back(owner);
    }
    return slot_of[owner];
  };
  for (std::uint32_t i = block.begin * per_grain; i < block.end * per_grain; ++i) {
    const Eigen::Vector3d here = spheres.position[i];
    const std::uint32_t own_grain = i / per_grain;
    cells_.visit_neighbourhood(here, [&](std::uint32_t j, const Eigen::Vector3d& there) {
      if ((there - here).squaredNorm() >= reach * reach) return;
      const std::uint32_t grain = j / per_grain;
      const std::uint32_t owner = grain < grains ? grain : spheres.images[grain - grains].owner;
      // Every pair once, by the grain that comes first; an image stands for its owner.
      if (owner <= own_grain) return;
      const auto* remembered = history.find(i, owner * per_grain + j % per_grain);
      block.grain_pairs.add({j, grain, slot_for(owner)}, remembered != nullptr,
                            remembered ? remembered->spring : Eigen::Vector3d::Zero());
    });
    block.grain_pairs.first.push_back(static_cast<std::uint32_t>(block.grain_pairs.partner.size()));
  }
  for (const std::uint32_t owner : block.foreign) slot_of[owner] = kGone;
}

void NeighbourList::find_wall_pairs(Block& block, const SphereField& spheres,
                                    const std::vector<WallBody>& bodies, const std::vector<BodyMotion>& poses,
                                    const ContactHistory& history) const {
  const auto per_grain = static_cast<std::uint32_t>(spheres.spheres_per_grain);
  block.wall_pairs.clear();
  std::vector<std::uint32_t> found;
  for (std::uint32_t i = block.begin * per_grain; i < block.end * per_grain; ++i) {
    for (std::uint32_t b = 0; b < bodies.size(); ++b) {
      found.clear();
      const Eigen::Vector3d body_point =
          poses[b].rotation.transpose() * (spheres.position[i] - poses[b].translation);
      bodies[b].find(body_point, found);
      for (const std::uint32_t w : found) {
        const auto* remembered = history.find(i, body_first_[b] + w);
        block.wall_pairs.add({w, b}, remembered != nullptr,
                             remembered ? remembered->spring : Eigen::Vector3d::Zero());
      }
    }
    block.wall_pairs.first.push_back(static_cast<std::uint32_t>(block.wall_pairs.partner.size()));
  }
}

void NeighbourList::index_foreign_sums(std::size_t grains) {
  foreign_first_.assign(grains + 1, 0);
  for (const auto& block : blocks_)
    for (const std::uint32_t owner : block.foreign) ++foreign_first_[owner + 1];
  std::partial_sum(foreign_first_.begin(), foreign_first_.end(), foreign_first_.begin());
  foreign_sums_.resize(foreign_first_.back());
  std::vector<std::uint32_t> next(foreign_first_.begin(), foreign_first_.end() - 1);
  for (std::uint32_t b = 0; b < blocks_.size(); ++b)
    for (std::uint32_t k = 0; k < blocks_[b].foreign.size(); ++k)
      foreign_sums_[next[blocks_[b].foreign[k]]++] = {b, blocks_[b].grains() + k};
}

}  // namespace diefill::engine
