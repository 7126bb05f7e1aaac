#include "engine/contact_history.h"

#include <numeric>

namespace diefill::engine {

void ContactHistory::add(std::uint32_t a, std::uint32_t b, const double* memory, const double* sign) {
  added_.push_back({a, b, memory_.size() - 1});
  memory_.pop_back();
  for (std::size_t k = 0; k < width_; ++k) memory_.push_back(sign ? sign[k] * memory[k] : memory[k]);
  memory_.push_back(0.0);
}

void ContactHistory::sort(std::size_t spheres) {
  first_.assign(spheres + 1, 0);
  for (const auto& entry : added_) ++first_[entry.a + 1];
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  sorted_.resize(added_.size());
  std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
  for (const auto& entry : added_) sorted_[next[entry.a]++] = entry;
  added_.clear();
}

namespace {

std::uint32_t renamed(std::uint32_t sphere, std::uint32_t per_grain,
                      const std::vector<std::uint32_t>& new_place) {
  const std::uint32_t grain = new_place[sphere / per_grain];
  return grain == kGone ? kGone : grain * per_grain + sphere % per_grain;
}

}  // namespace

ContactHistory remember_grain_contacts(const std::vector<Block>& blocks, const PairNaming& naming,
                                       const std::vector<std::uint32_t>& new_place,
                                       const std::vector<double>& sign, std::size_t spheres) {
  const auto per_grain = static_cast<std::uint32_t>(naming.spheres_per_grain);
  ContactHistory history(sign.size());
  for (const auto& block : blocks) {
    const auto& table = block.grain_pairs;
    table.visit_touching([&](std::size_t p, const double* memory) {
      const std::uint32_t a = renamed(block.sphere(table.pair[p].own), per_grain, new_place);
      const std::uint32_t b =
          renamed(naming.real_sphere(block.sphere(table.pair[p].other)), per_grain, new_place);
      if (a == kGone || b == kGone) return;
      if (a < b)
        history.add(a, b, memory, nullptr);
      else
        history.add(b, a, memory, sign.data());
    });
  }
  history.sort(spheres);
  return history;
}

ContactHistory remember_wall_contacts(const std::vector<Block>& blocks, const PairNaming& naming,
                                      const std::vector<std::uint32_t>& new_place, std::size_t width,
                                      std::size_t spheres) {
  const auto per_grain = static_cast<std::uint32_t>(naming.spheres_per_grain);
  ContactHistory history(width);
  for (const auto& block : blocks) {
    const auto& table = block.wall_pairs;
    for (std::size_t body = 0; body + 1 < block.wall_first.size(); ++body)
      for (std::uint32_t p = block.wall_first[body]; p < block.wall_first[body + 1]; ++p) {
        if (!table.touching[p]) continue;
        const std::uint32_t a = renamed(block.sphere(table.pair[p].own), per_grain, new_place);
        if (a != kGone)
          history.add(a, (*naming.body_first)[body] + table.pair[p].wall, table.memory_of(p), nullptr);
      }
  }
  history.sort(spheres);
  return history;
}

}  // namespace diefill::engine
