#include "engine/contact_history.h"

#include <numeric>

namespace diefill::engine {

ContactHistory::ContactHistory(std::vector<RememberedContact> contacts, std::size_t spheres) {
  first_.assign(spheres + 1, 0);
  for (const auto& contact : contacts) ++first_[contact.a + 1];
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  contacts_.resize(contacts.size());
  std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
  for (const auto& contact : contacts) contacts_[next[contact.a]++] = contact;
}

namespace {

/// Calls visit(own sphere, pair number, table) for every touching pair of the block's table.
template <class Partner, class Visit>
void visit_touching(const Block& block, const PairTable<Partner>& table, std::size_t per_grain,
                    const Visit& visit) {
  for (std::size_t s = 0; s + 1 < table.first.size(); ++s)
    for (std::uint32_t p = table.first[s]; p < table.first[s + 1]; ++p)
      if (table.touching[p]) visit(static_cast<std::uint32_t>(block.begin * per_grain + s), p);
}

std::uint32_t renamed(std::uint32_t sphere, std::uint32_t per_grain,
                      const std::vector<std::uint32_t>& new_place) {
  const std::uint32_t grain = new_place[sphere / per_grain];
  return grain == kGone ? kGone : grain * per_grain + sphere % per_grain;
}

}  // namespace

std::vector<RememberedContact> remember_grain_contacts(const std::vector<Block>& blocks,
                                                       const PairNaming& naming,
                                                       const std::vector<std::uint32_t>& new_place) {
  const auto per_grain = static_cast<std::uint32_t>(naming.spheres_per_grain);
  std::vector<RememberedContact> contacts;
  for (const auto& block : blocks)
    visit_touching(block, block.grain_pairs, per_grain, [&](std::uint32_t sphere, std::uint32_t p) {
      const std::uint32_t a = renamed(sphere, per_grain, new_place);
      const std::uint32_t b =
          renamed(naming.real_sphere(block.grain_pairs.partner[p].sphere), per_grain, new_place);
      if (a == kGone || b == kGone) return;
      const Eigen::Vector3d& spring = block.grain_pairs.spring[p];
      if (a < b)
        contacts.push_back({a, b, spring});
      else
        contacts.push_back({b, a, -spring});
    });
  return contacts;
}

std::vector<RememberedContact> remember_wall_contacts(const std::vector<Block>& blocks,
                                                      const PairNaming& naming,
                                                      const std::vector<std::uint32_t>& new_place) {
  const auto per_grain = static_cast<std::uint32_t>(naming.spheres_per_grain);
  std::vector<RememberedContact> contacts;
  for (const auto& block : blocks)
    visit_touching(block, block.wall_pairs, per_grain, [&](std::uint32_t sphere, std::uint32_t p) {
      const std::uint32_t a = renamed(sphere, per_grain, new_place);
      if (a == kGone) return;
      const WallPartner& partner = block.wall_pairs.partner[p];
      contacts.push_back(
          {a, (*naming.body_first)[partner.body] + partner.sphere, block.wall_pairs.spring[p]});
    });
  return contacts;
}

}  // namespace diefill::engine
