// Effects of the factors of a two-level design on a measured quantity, with their standard errors (Kottlan
// 2018, section 2.5.1).
#pragma once

#include <string>
#include <vector>

#include "process/calibration/methods/fractional_design.h"

namespace diefill::process::calibration {

/// The effect of an alias string: mean at its high level less mean at its low level, in the quantity's unit.
struct Effect {
  AliasString string;
  double value = 0;
};

/// Where the standard error of effects comes from.
enum class ErrorSource {
  repeats,  ///< runs of the same settings, pooled over all settings
  lenth,    ///< the smaller effects themselves, most of which are taken for scatter (Lenth 1989)
  zeros,    ///< nowhere: more than half of the effects are 0, so that they tell no scatter
  none      ///< nowhere: too few runs
};

struct ScreeningEffects {
  double mean = 0;              ///< over all settings
  std::vector<Effect> effects;  ///< in the order of alias_strings()
  double error = 0;             ///< standard error of an effect; NaN: not known
  double margin = 0;            ///< half width of its 95 % interval by Student's t; NaN: not known
  ErrorSource source = ErrorSource::none;
};

/// `responses`: run by run in the design's order, each with one value or more (repeats with other seeds).
/// Effects without repeats have Lenth's pseudo standard error (R. V. Lenth, Technometrics 31, 1989) from the
/// contrasts of all columns, with a third as many degrees of freedom; at least seven contrasts are needed,
/// half of them or more not 0. Throws std::invalid_argument where a run is missing or without a value.
ScreeningEffects screening_effects(const FractionalDesign& design,
                                   const std::vector<std::vector<double>>& responses);

/// Contrast of one column: mean at high less mean at low over the design's runs, each with its mean.
double contrast(const FractionalDesign& design, const std::vector<double>& means, std::uint64_t column);

}  // namespace diefill::process::calibration
