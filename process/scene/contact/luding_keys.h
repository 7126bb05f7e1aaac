// Keys of Luding's spring: stiffnesses, or Young's modulus with a reference overlap and ratios (Kottlan 2018,
// Eqs. 3, 10 and 11).
#pragma once

#include <cmath>
#include <string>

#include "process/scene/contact/contact_key.h"

namespace diefill::process {

/// A stiffness that may be given over k_1 instead. `ratio`: its rule.
inline ContactKey<engine::laws::LudingNormal::Parameters> stiffness_or_ratio(
    const ContactKey<engine::laws::LudingNormal::Parameters>& stiffness, const std::string& name,
    double engine::laws::LudingNormal::Parameters::*member, NumberRule ratio) {
  auto key = stiffness;
  key.read = [=](TableReader& table, const PowderSpec& powder, auto& parameters) {
    if (!table.has(name)) return stiffness.read(table, powder, parameters);
    if (table.has(stiffness.name))
      table.reject(name, stiffness.name + " is given as well; remove one of the two");
    parameters.*member = *table.number(name, ratio) * parameters.loading;
  };
  return key;
}

/// k_1, or 4/3 Y r sqrt(delta') of `young_modulus` Y, the powder's radius r and `reference_overlap` delta'
/// over r. Read before the ratios.
inline ContactKey<engine::laws::LudingNormal::Parameters> loading_or_modulus(
    const ContactKey<engine::laws::LudingNormal::Parameters>& stiffness, QuantityRule modulus,
    NumberRule overlap) {
  auto key = stiffness;
  key.read = [=](TableReader& table, const PowderSpec& powder, auto& parameters) {
    const auto given = table.quantity("young_modulus", modulus);
    if (!given) return stiffness.read(table, powder, parameters);
    if (table.has(stiffness.name))
      table.reject("young_modulus", stiffness.name + " is given as well; remove one of the two");
    const double depth = table.number("reference_overlap", overlap).value_or(0.01);
    parameters.loading = 4.0 / 3 * *given * powder.sphere_radius * std::sqrt(depth);
  };
  return key;
}

}  // namespace diefill::process
