// Rebuilds the neighbour list: sorts the grains in space, and carries the contact history over.
#pragma once

#include <functional>

#include "engine/simulation/step_policy.h"

namespace diefill::engine {

/// The contact history, by the numbers that spheres have in a new order.
struct ContactHistories {
  ContactHistory grains, walls;
};

/// A new order of the grains: entry k is the present place of the grain that comes to place k. Grains that it
/// leaves out are gone.
struct NewOrder {
  std::vector<std::uint32_t> order;
  std::size_t awake;  ///< number of its first grains that share blocks only with each other
  ContactHistories histories;
};

/// Appends to SphereField::images those that grains within `margin` (m) of borders are seen in. None: those
/// of the periodic box.
using ImageFinder = std::function<void(SimulationState& state, double margin)>;

/// Sorts all grains in space and finds their near pairs. Throws OutOfRange when grains have flown beyond all
/// bounds.
void sort_and_search(SimulationState& state, StepPolicy& policy);
/// The same with the grains of `order` only, in that order.
void search_in_order(SimulationState& state, StepPolicy& policy, std::vector<std::uint32_t> order);

/// The first half of sort_and_search(): the order in space, with the present contact history.
NewOrder sort_in_space(SimulationState& state, StepPolicy& policy);
/// The second half.
void search_again(SimulationState& state, StepPolicy& policy, const NewOrder& sorted,
                  const ImageFinder& images = {});

/// Finds near pairs of the grains where SimulationState::reference has them.
void search_at_reference(SimulationState& state, const ContactHistories& histories,
                         const ImageFinder& images = {});

/// Puts grains that have left the periodic box back into it. Searches find images of grains in the box only.
void wrap_grains(SimulationState& state);

}  // namespace diefill::engine
