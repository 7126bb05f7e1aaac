#include "engine/contact_history.h"

#include <algorithm>
#include <numeric>

namespace diefill::engine {

void ContactHistory::make_places() {
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  partner_.resize(first_.back());
  // One number more, so that find() can point to what pairs without memory remember.
  memory_.resize(partner_.size() * width_ + 1);
}

void ContactHistory::add(std::uint32_t a, std::uint32_t b, const double* memory, const double* sign) {
  const std::uint32_t place = first_[a + 1]++;
  partner_[place] = b;
  for (std::size_t k = 0; k < width_; ++k)
    memory_[place * width_ + k] = sign ? sign[k] * memory[k] : memory[k];
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
  const auto visit_all = [&](const auto& visit) {
    for (const auto& block : blocks) {
      const auto& table = block.grain_pairs;
      table.visit_touching([&](std::size_t p, const double* memory) {
        const std::uint32_t a = renamed(block.sphere(table.pair[p].own), per_grain, new_place);
        const std::uint32_t b =
            renamed(naming.real_sphere(block.sphere(table.pair[p].other)), per_grain, new_place);
        if (a != kGone && b != kGone) visit(a, b, memory);
      });
    }
  };
  ContactHistory history(sign.size(), spheres);
  visit_all([&](std::uint32_t a, std::uint32_t b, const double*) { history.announce(std::min(a, b)); });
  history.make_places();
  visit_all([&](std::uint32_t a, std::uint32_t b, const double* memory) {
    history.add(std::min(a, b), std::max(a, b), memory, a < b ? nullptr : sign.data());
  });
  return history;
}

ContactHistory remember_wall_contacts(const std::vector<Block>& blocks, const PairNaming& naming,
                                      const std::vector<std::uint32_t>& new_place, std::size_t width,
                                      std::size_t spheres) {
  const auto per_grain = static_cast<std::uint32_t>(naming.spheres_per_grain);
  const auto visit_all = [&](const auto& visit) {
    for (const auto& block : blocks) {
      const auto& table = block.wall_pairs;
      for (std::size_t body = 0; body + 1 < block.wall_first.size(); ++body)
        for (std::uint32_t p = block.wall_first[body]; p < block.wall_first[body + 1]; ++p) {
          if (!table.touching[p]) continue;
          const std::uint32_t a = renamed(block.sphere(table.pair[p].own), per_grain, new_place);
          if (a != kGone) visit(a, (*naming.body_first)[body] + table.pair[p].wall, table.memory_of(p));
        }
    }
  };
  ContactHistory history(width, spheres);
  visit_all([&](std::uint32_t a, std::uint32_t, const double*) { history.announce(a); });
  history.make_places();
  visit_all(
      [&](std::uint32_t a, std::uint32_t b, const double* memory) { history.add(a, b, memory, nullptr); });
  return history;
}

}  // namespace diefill::engine
