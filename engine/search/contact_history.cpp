#include "engine/search/contact_history.h"

#include <algorithm>
#include <numeric>

#include "engine/numerics/shared_ranges.h"

namespace diefill::engine {

void ContactHistory::finish_reserving() {
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  partner_.resize(first_.back());
  // One number more, so that find() can point to the history of pairs of width 0.
  history_.resize(partner_.size() * width_ + 1);
}

void ContactHistory::add(std::uint32_t a, std::uint32_t b, const double* history, const double* sign) {
  const std::uint32_t place = first_[a + 1]++;
  partner_[place] = b;
  for (std::size_t k = 0; k < width_; ++k)
    history_[place * width_ + k] = sign ? sign[k] * history[k] : history[k];
}

namespace {

std::uint32_t renamed(std::uint32_t sphere, std::uint32_t per_grain,
                      const std::vector<std::uint32_t>& new_place) {
  const std::uint32_t grain = new_place[sphere / per_grain];
  return grain == kGone ? kGone : grain * per_grain + sphere % per_grain;
}

/// A touching pair by its lasting names.
struct NamedPair {
  std::uint32_t a, b;
  const double* history;
  const double* sign;
};

/// The history of `spheres` spheres from what visit(block, note) reports of each block, in the order of the
/// blocks.
template <class Visit>
ContactHistory history_of(const std::vector<Block>& blocks, std::size_t width, std::size_t spheres,
                          ThreadPool& pool, const Visit& visit) {
  std::vector<std::vector<NamedPair>> noted(blocks.size());
  pool.for_each(blocks.size(), [&](std::size_t b) {
    visit(blocks[b], [&](const NamedPair& pair) { noted[b].push_back(pair); });
  });
  const auto for_all_by_sphere = [&](const auto& use) {
    in_shares(spheres, static_cast<std::size_t>(pool.threads()), pool, [&](Share share) {
      for (const auto& pairs : noted)
        for (const NamedPair& pair : pairs)
          if (share.has(pair.a)) use(pair);
    });
  };
  ContactHistory history(width, spheres);
  for_all_by_sphere([&](const NamedPair& pair) { history.reserve_pair(pair.a); });
  history.finish_reserving();
  for_all_by_sphere([&](const NamedPair& pair) { history.add(pair.a, pair.b, pair.history, pair.sign); });
  return history;
}

}  // namespace

ContactHistory grain_contact_history(const std::vector<Block>& blocks, const PairNaming& naming,
                                     const std::vector<std::uint32_t>& new_place,
                                     const std::vector<double>& sign, std::size_t spheres, ThreadPool& pool) {
  const auto per_grain = static_cast<std::uint32_t>(naming.spheres_per_grain);
  return history_of(blocks, sign.size(), spheres, pool, [&](const Block& block, const auto& note) {
    const auto& table = block.grain_pairs;
    table.visit_touching([&](std::size_t p, const double* history) {
      const std::uint32_t a = renamed(block.sphere(table.pair[p].own), per_grain, new_place);
      const std::uint32_t b =
          renamed(naming.real_sphere(block.sphere(table.pair[p].other)), per_grain, new_place);
      if (a != kGone && b != kGone)
        note({std::min(a, b), std::max(a, b), history, a < b ? nullptr : sign.data()});
    });
  });
}

ContactHistory wall_contact_history(const std::vector<Block>& blocks, const PairNaming& naming,
                                    const std::vector<std::uint32_t>& new_place, std::size_t width,
                                    std::size_t spheres, ThreadPool& pool) {
  const auto per_grain = static_cast<std::uint32_t>(naming.spheres_per_grain);
  return history_of(blocks, width, spheres, pool, [&](const Block& block, const auto& note) {
    const auto& table = block.wall_pairs;
    for (std::size_t body = 0; body + 1 < block.wall_first.size(); ++body)
      for (std::uint32_t p = block.wall_first[body]; p < block.wall_first[body + 1]; ++p) {
        if (!table.touching[p]) continue;
        const std::uint32_t a = renamed(block.sphere(table.pair[p].own), per_grain, new_place);
        if (a != kGone)
          note({a, (*naming.body_first)[body] + table.pair[p].wall, table.history_of(p), nullptr});
      }
  });
}

}  // namespace diefill::engine
