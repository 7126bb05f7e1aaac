// The laws of discharge that can be fitted to measurements, by name, and what all who use them ask about
// each.
#pragma once

#include <span>
#include <string>

namespace diefill::process::continuum {

enum class DischargeLaw { moving_shoe, power_law, transient, beverloo_round, beverloo_slit };

std::span<const DischargeLaw> discharge_laws();

/// As it is called on the command line: "5.17", "5.18", "transient", "beverloo-round", "beverloo-slit".
std::string name_of(DischargeLaw law);
/// The formula in one line, with its source.
std::string formula_of(DischargeLaw law);

/// Whether its values are steady rates (kg/s) through openings; of the other laws they are masses (kg).
bool is_of_rates(DischargeLaw law);
/// Whether its masses are those that a moving shoe leaves in an opening.
bool is_of_shoe(DischargeLaw law);

}  // namespace diefill::process::continuum
