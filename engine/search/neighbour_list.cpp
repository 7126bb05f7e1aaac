#include "engine/search/neighbour_list.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "engine/numerics/out_of_range.h"
#include "engine/numerics/per_worker.h"

namespace diefill::engine {

namespace {

/// Spheres of a block, and number of blocks where these allow it: few, so that few pairs cross a border, but
/// enough for threads to share the work evenly, and each small enough for its spheres and sums to stay in the
/// second-level cache.
constexpr std::size_t kSmallestBlock = 1024, kLargestBlock = 2048, kBlocks = 32;
/// The same for powder too large for any cache:
/// what crosses a border comes from memory then, and costs more.
constexpr std::size_t kLargestFromMemory = 4096, kBlocksFromMemory = 256;
/// The same for sleeping grains: one that wakes makes its whole block active.
constexpr std::size_t kSpheresPerSleepingBlock = 128;
/// Spheres down to this share of a level's largest radius are in its cells: eight fit where the largest
/// would.
constexpr double kSmallestOfLevel = 0.5;

/// Block borders depend on the number of grains only.
std::size_t spheres_per_block(std::size_t spheres) {
  return std::clamp(spheres / kBlocksFromMemory, std::clamp(spheres / kBlocks, kSmallestBlock, kLargestBlock),
                    kLargestFromMemory);
}

/// A near pair of a block's own sphere and another, which may be of an image: numbers among all spheres.
struct FoundPair {
  std::uint32_t own, other;
};

void sort_unique(std::vector<std::uint32_t>& numbers) {
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
}

/// The inverse of Block::sphere().
LocalSphere local_number(const Block& block, std::uint32_t sphere) {
  const std::uint32_t first = block.begin * block.spheres_per_grain, own = block.own_spheres();
  if (sphere >= first && sphere < first + own) return static_cast<LocalSphere>(sphere - first);
  const auto place = std::lower_bound(block.partners.begin(), block.partners.end(), sphere);
  return static_cast<LocalSphere>(own + (place - block.partners.begin()));
}

/// The table of the block's pairs between grains with their histories; its partners must be known.
/// `opposite`: factor of each number of a history when the pair is stored the other way round.
void fill_grain_table(Block& block, const std::vector<FoundPair>& found, const SphereField& spheres,
                      const ContactHistory& history, const std::vector<double>& opposite) {
  block.grain_pairs.start(found.size(), opposite.size());
  for (const FoundPair& pair : found) {
    const auto other = static_cast<std::uint32_t>(spheres.original(pair.other));
    const GrainPair named = {local_number(block, pair.own), local_number(block, pair.other)};
    if (pair.own < other)
      block.grain_pairs.add(named, history.find(pair.own, other), nullptr);
    else
      block.grain_pairs.add(named, history.find(other, pair.own), opposite.data());
  }
  block.grain_pairs.finish();
}

}  // namespace

NeighbourList::NeighbourList(const NeighbourSettings& settings, std::vector<std::uint32_t> body_first)
    : settings_(settings), body_first_(std::move(body_first)) {
  const auto& radii = settings_.sphere_radii;
  std::vector<std::size_t> order(radii.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return radii[a] > radii[b]; });
  level_of_class_.resize(radii.size());
  for (const std::size_t one : order) {
    if (levels_.empty() || radii[one] < kSmallestOfLevel * levels_.back().largest)
      levels_.emplace_back().largest = radii[one];
    level_of_class_[one] = static_cast<std::uint8_t>(levels_.size() - 1);
  }
}

void NeighbourList::build(const SphereField& spheres, const std::vector<WallBody>& bodies,
                          const ListReference& reference, const ContactHistory& history,
                          const ContactHistory& wall_history, ThreadPool& pool) {
  sort_into_cells(spheres, reference, pool);
  const auto per_grain = static_cast<std::uint32_t>(spheres.spheres_per_grain);
  count_ = 0;
  cut_into_blocks(0, reference.awake_grains,
                  spheres_per_block(reference.awake_grains * per_grain) / per_grain + 1);
  cut_into_blocks(reference.awake_grains, spheres.grains, kSpheresPerSleepingBlock / per_grain + 1);
  blocks_.resize(count_);
  for (auto& block : blocks_) block.spheres_per_grain = per_grain;
  PerWorker<SearchWorkspace> workspaces(pool.threads());
  pool.for_each_by_worker(blocks_.size(), [&](std::size_t b, std::size_t worker) {
    Block& block = blocks_[b];
    SearchWorkspace& workspace = workspaces[worker];
    block.reference = reference.position[(block.begin + block.end) / 2];
    if (one_class())
      find_grain_pairs<true>(block, spheres, reference, history, workspace);
    else
      find_grain_pairs<false>(block, spheres, reference, history, workspace);
    find_wall_pairs(block, spheres, bodies, reference, wall_history, workspace);
    block.sums.start(block.grains() + block.foreign.size(), settings_.sum_numbers);
  });
  index_foreign_sums();
  // Between searches they would be the largest unused arrays in memory.
  for (auto& level : levels_) level.cells = {};
}

void NeighbourList::sort_into_cells(const SphereField& spheres, const ListReference& reference,
                                    ThreadPool& pool) {
  const auto edge = [&](const SizeLevel& level) {
    return 2 * level.largest + settings_.law_range + reference.skin;
  };
  const std::size_t groups = reference.groups();
  if (levels_.size() == 1 && groups == 1 && spheres.equal_counts)
    return levels_.front().cells[0].build(spheres, edge(levels_.front()), pool);
  std::vector<std::array<std::vector<std::uint32_t>, 2>> members(levels_.size());
  for (std::uint32_t j = 0; j < spheres.size(); ++j) {
    if (!spheres.exists(j)) continue;
    const std::size_t level = one_class() ? 0 : level_of_class_[spheres.class_of(j)];
    members[level][reference.group_of(spheres.owner(j))].push_back(j);
  }
  for (std::size_t l = 0; l < levels_.size(); ++l)
    for (std::size_t group = 0; group < groups; ++group)
      levels_[l].cells[group].build(spheres, std::move(members[l][group]), edge(levels_[l]), pool);
}

std::size_t NeighbourList::near_pairs() const {
  std::size_t pairs = 0;
  for (const auto& block : blocks_) pairs += block.grain_pairs.size();
  return pairs;
}

/// Adds blocks of the grains [begin, end). Blocks of the list before are used again, with their memory.
void NeighbourList::cut_into_blocks(std::size_t begin, std::size_t end, std::size_t grains_per_block) {
  const std::size_t grains = end - begin;
  const std::size_t added = (grains + grains_per_block - 1) / grains_per_block;
  if (blocks_.size() < count_ + added) blocks_.resize(count_ + added);
  for (std::size_t b = 0; b < added; ++b) {
    Block& block = blocks_[count_ + b];
    block.begin = static_cast<std::uint32_t>(begin + grains * b / added);
    block.end = static_cast<std::uint32_t>(begin + grains * (b + 1) / added);
  }
  count_ += added;
}

/// Local numbers and sums of the block's spheres and of `partners`, which must be known.
void NeighbourList::number_spheres(Block& block, const SphereField& spheres) const {
  const auto per_grain = static_cast<std::uint32_t>(spheres.spheres_per_grain);
  const std::size_t all = block.own_spheres() + block.partners.size();
  if (all > std::numeric_limits<LocalSphere>::max())
    throw OutOfRange(
        "a grain has thousands of neighbours: powder has been pressed into itself, or its grains "
        "are made of too many spheres");
  block.sphere_class.clear();
  if (!one_class()) {
    for (std::uint32_t k = 0; k < block.own_spheres(); ++k)
      block.sphere_class.push_back(spheres.class_of(block.begin * per_grain + k));
    for (const std::uint32_t sphere : block.partners) block.sphere_class.push_back(spheres.class_of(sphere));
  }
  block.slot.clear();
  if (per_grain > 1) block.slot.reserve(all);
  for (std::uint32_t k = 0; per_grain > 1 && k < block.own_spheres(); ++k)
    block.slot.push_back(static_cast<std::uint16_t>(k / per_grain));
  block.foreign.clear();
  block.seen.clear();
  std::uint32_t last = kGone;
  for (const std::uint32_t sphere : block.partners) {
    const std::uint32_t grain = sphere / per_grain;
    if (grain != last) {
      block.foreign.push_back(static_cast<std::uint32_t>(spheres.owner(sphere)));
      if (per_grain > 1) block.seen.push_back(grain);
      last = grain;
    }
    if (per_grain > 1)
      block.slot.push_back(static_cast<std::uint16_t>(block.grains() + block.foreign.size() - 1));
  }
  block.foreign.shrink_to_fit();
  block.seen.shrink_to_fit();
}

template <bool kMonodisperse>
void NeighbourList::find_grain_pairs(Block& block, const SphereField& spheres, const ListReference& reference,
                                     const ContactHistory& history, SearchWorkspace& workspace) const {
  const auto per_grain = static_cast<std::uint32_t>(spheres.spheres_per_grain);
  const std::uint32_t first = block.begin * per_grain, end = block.end * per_grain;
  std::vector<FoundPair> found;
  block.partners.clear();
  for (std::uint32_t i = first; i < end; ++i) {
    if (!kMonodisperse && !spheres.exists(i)) continue;
    const Vector3 here = spheres.position(i);
    const std::uint32_t grain = i / per_grain;
    const std::uint8_t doublings = reference.doublings[grain];
    const double radius = settings_.sphere_radii[kMonodisperse ? 0 : spheres.class_of(i)];
    const auto find = [&](const SizeLevel& level, std::size_t group) {
      const double passing = group == reference.group_of(grain) ? 0 : reference.passing;
      const double touching = radius + level.largest + settings_.law_range;
      const double farthest = touching + passing + 2 * reference.allowance(grain);
      const SphereCells& cells = level.cells[group];
      cells.visit_nearer(here, farthest, workspace.candidates, [&](const SphereCells::Near& near) {
        // Every pair once: by the faster grain, which searches farther, else by the first; an image counts
        // for its owner.
        const auto [j, other] = near.member;
        const std::uint8_t other_doublings = reference.doublings[other];
        if (other_doublings > doublings || (other_doublings == doublings && other <= grain) || other == grain)
          return;
        const double touching_now =
            kMonodisperse ? touching
                          : radius + settings_.sphere_radii[spheres.class_of(j)] + settings_.law_range;
        const double reach = touching_now + passing + reference.allowance(grain) + reference.allowance(other);
        if (near.square >= reach * reach) return;
        found.push_back({i, j});
        if (j < first || j >= end) block.partners.push_back(j);
      });
    };
    for (const SizeLevel& level : levels_)
      for (std::size_t group = 0; group < reference.groups(); ++group) find(level, group);
  }
  sort_unique(block.partners);
  block.partners.shrink_to_fit();
  number_spheres(block, spheres);
  fill_grain_table(block, found, spheres, history, settings_.grain_history_sign);
}

void NeighbourList::index_foreign_sums() {
  std::vector<std::uint32_t> home(blocks_.empty() ? 0 : blocks_.back().end);
  for (std::uint32_t b = 0; b < blocks_.size(); ++b)
    std::fill(home.begin() + blocks_[b].begin, home.begin() + blocks_[b].end, b);
  foreign_first_.assign(blocks_.size() + 1, 0);
  waiting_first_.assign(1, 0);
  waiting_.clear();
  awaited_.assign(blocks_.size(), 0);
  std::vector<std::uint32_t> homes;
  for (std::uint32_t b = 0; b < blocks_.size(); ++b) {
    homes.assign(1, b);
    for (const std::uint32_t grain : blocks_[b].foreign) {
      homes.push_back(home[grain]);
      ++foreign_first_[homes.back() + 1];
    }
    note_waiting(homes);
  }
  std::partial_sum(foreign_first_.begin(), foreign_first_.end(), foreign_first_.begin());
  make_room(foreign_sums_, foreign_first_.back());
  foreign_sums_.resize(foreign_first_.back());
  std::vector<std::uint32_t> next(foreign_first_.begin(), foreign_first_.end() - 1);
  for (std::uint32_t b = 0; b < blocks_.size(); ++b)
    for (std::uint32_t k = 0; k < blocks_[b].foreign.size(); ++k) {
      const std::uint32_t grain = blocks_[b].foreign[k];
      const std::uint32_t own = home[grain];
      foreign_sums_[next[own]++] = {b, static_cast<std::uint16_t>(blocks_[b].grains() + k),
                                    static_cast<std::uint16_t>(grain - blocks_[own].begin)};
    }
}

/// Adds the next block's row to the blocks that wait: `homes`, itself among them, each as often as it is met.
void NeighbourList::note_waiting(std::vector<std::uint32_t>& homes) {
  sort_unique(homes);
  waiting_.insert(waiting_.end(), homes.begin(), homes.end());
  waiting_first_.push_back(static_cast<std::uint32_t>(waiting_.size()));
  for (const std::uint32_t other : homes) ++awaited_[other];
}

}  // namespace diefill::engine
