// Mass and solid volume of grains, each with its own.
#pragma once

#include "process/results/fill_result.h"

namespace diefill::process {

/// Sum of `one(k)` over the grains `list`, where `same` is that of each grain of powder of one size: as many
/// times as there are grains, so that sums of many do not gather rounding.
template <class List, class One>
double sum_over(const results::PowderState& powder, const List& list, double same, const One& one) {
  if (powder.monodisperse()) return static_cast<double>(list.size()) * same;
  double sum = 0;
  for (const std::size_t k : list) sum += one(k);
  return sum;
}

/// m^3, solid volume of the grains of these numbers.
template <class List>
double solid_volume(const results::PowderState& powder, const List& list) {
  return sum_over(powder, list, powder.grain_solid_volume,
                  [&](std::size_t k) { return powder.solid_volume_of(k); });
}

/// kg, mass of the grains of these numbers.
template <class List>
double mass(const results::PowderState& powder, const List& list) {
  return sum_over(powder, list, powder.grain_mass, [&](std::size_t k) { return powder.mass_of(k); });
}

}  // namespace diefill::process
