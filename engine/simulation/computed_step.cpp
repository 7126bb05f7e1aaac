#include "engine/simulation/computed_step.h"

#include <stdexcept>

#include "engine/search/spatial_order.h"
#include "engine/simulation/contact_search.h"
#include "engine/simulation/simulation.h"
#include "engine/simulation/step_phases.h"

namespace diefill::engine {

namespace {

constexpr std::uint32_t kNowhere = 0xffffffff;

/// Place of each id in `grains`; kNowhere for ids that have left.
std::vector<std::uint32_t> places_of(const Grains& grains, std::uint64_t ids) {
  std::vector<std::uint32_t> place(ids, kNowhere);
  for (std::uint32_t k = 0; k < grains.size(); ++k) place.at(grains.id[k]) = k;
  return place;
}

std::uint32_t place_in(const std::vector<std::uint32_t>& places, std::uint64_t id) {
  if (id >= places.size() || places[id] == kNowhere)
    throw std::invalid_argument("grain " + std::to_string(id) +
                                " was computed, but is not in the simulation");
  return places[id];
}

/// `named` as the search takes histories: `partner` makes the number that stands second from a pair.
template <class Partner>
ContactHistory history_of(const NamedContacts& named, std::size_t width, std::size_t spheres,
                          const std::vector<double>& sign, const std::vector<std::uint32_t>& places,
                          std::uint32_t per_grain, const Partner& partner) {
  ContactHistory history(width, spheres);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> numbers;
  for (const auto& pair : named.pair) {
    const std::uint32_t own = place_in(places, pair.grain) * per_grain + pair.sphere;
    numbers.emplace_back(own, partner(pair));
  }
  const auto turned = [&](std::size_t k) { return !sign.empty() && numbers[k].second < numbers[k].first; };
  for (std::size_t k = 0; k < numbers.size(); ++k)
    history.reserve_pair(turned(k) ? numbers[k].second : numbers[k].first);
  history.finish_reserving();
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    const auto [own, other] = numbers[k];
    const double* stored = named.history.data() + k * width;
    if (turned(k))
      history.add(other, own, stored, sign.data());
    else
      history.add(own, other, stored, nullptr);
  }
  return history;
}

}  // namespace

void Simulation::apply_computed_step(const ComputedStep& computed) {
  SimulationState& now = state_;
  now.time = static_cast<double>(++now.step) * now.settings.time_step;
  move_bodies(now);
  now.wall_loads = computed.loads;
  now.touching = computed.touching;
  now.overlap = computed.overlap;
  now.overlap_of_run.include(computed.overlap);
  Ledger& ledger = now.ledger;
  ledger.viscous_work += computed.work.viscous_work;
  ledger.tangential_work += computed.work.tangential_work;
  ledger.drag_work += computed.work.drag_work;
  ledger.rolling_work += computed.work.rolling_work;
  add_wall_work(now);
}

void Simulation::apply_computed_grains(const Grains& computed) {
  Grains& grains = state_.grains;
  if (computed.size() != grains.size())
    throw std::invalid_argument("the computed grains are not those of the simulation");
  const auto places = places_of(grains, state_.next_id);
  for (std::size_t n = 0; n < computed.size(); ++n) {
    const std::uint32_t k = place_in(places, computed.id[n]);
    grains.position[k] = computed.position[n];
    grains.velocity[k] = computed.velocity[n];
    if (!grains.orientation.empty()) grains.orientation[k] = computed.orientation[n];
    grains.spin[k] = computed.spin[n];
    grains.force[k] = computed.force[n];
    grains.torque[k] = computed.torque[n];
  }
}

void Simulation::apply_computed_grains(const Grains& computed, const NamedContacts& of_grains,
                                       const NamedContacts& of_walls) {
  SimulationState& now = state_;
  apply_computed_grains(computed);
  wrap_grains(now);
  const double cell = now.types.monodisperse() ? 2 * now.types.largest_grain() : now.types.smallest_sphere();
  NewOrder sorted{spatial_order(now.grains.position, cell, now.pool), now.grains.size(), {}};
  Grains in_order = now.grains;
  in_order.reorder(sorted.order);
  const auto places = places_of(in_order, now.next_id);
  const auto per_grain = static_cast<std::uint32_t>(now.types.spheres());
  const std::size_t spheres = now.grains.size() * per_grain;
  const auto sign = now.grain_loop->history_signs();
  sorted.histories.grains = history_of(
      of_grains, sign.size(), spheres, sign, places, per_grain,
      [&](const auto& pair) { return place_in(places, pair.other) * per_grain + pair.other_sphere; });
  sorted.histories.walls =
      history_of(of_walls, now.list.settings().wall_history, spheres, {}, places, per_grain,
                 [](const auto& pair) { return static_cast<std::uint32_t>(pair.other); });
  search_again(now, *policy_, sorted);
  // Which block has the deepest overlap was not asked: any may.
  for (BlockTally& tally : now.tallies) {
    tally.start(now.bodies.size());
    tally.overlap = now.overlap;
  }
}

NamedContacts grain_contacts(const Simulation& simulation) {
  const SphereField& spheres = simulation.spheres();
  NamedContacts named;
  for (const Block& block : simulation.neighbours().blocks()) {
    const GrainPairTable& table = block.grain_pairs;
    table.visit_touching([&](std::size_t p, const double* history) {
      const std::uint32_t own = block.sphere(table.pair[p].own), other = block.sphere(table.pair[p].other);
      const auto number = [&](std::uint32_t sphere) {
        return static_cast<std::uint32_t>(sphere % spheres.spheres_per_grain);
      };
      const auto& id = simulation.grains().id;
      named.pair.push_back({id[spheres.owner(own)], id[spheres.owner(other)], number(own), number(other)});
      named.history.insert(named.history.end(), history, history + table.width);
    });
  }
  return named;
}

NamedContacts wall_contacts(const Simulation& simulation) {
  const SphereField& spheres = simulation.spheres();
  const auto& body_first = simulation.neighbours().body_first();
  NamedContacts named;
  for (const Block& block : simulation.neighbours().blocks()) {
    const auto& table = block.wall_pairs;
    for (std::size_t body = 0; body + 1 < block.wall_first.size(); ++body)
      for (std::uint32_t p = block.wall_first[body]; p < block.wall_first[body + 1]; ++p) {
        if (!table.touching[p]) continue;
        const std::uint32_t own = block.sphere(table.pair[p].own);
        named.pair.push_back({simulation.grains().id[spheres.owner(own)],
                              body_first[body] + table.pair[p].wall,
                              static_cast<std::uint32_t>(own % spheres.spheres_per_grain), 0});
        const double* history = table.history_of(p);
        named.history.insert(named.history.end(), history, history + table.width);
      }
  }
  return named;
}

}  // namespace diefill::engine
