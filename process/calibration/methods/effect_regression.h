// A quantity as a function of the parameters, from the effects of a two-level design: main and pair effects
// (Kottlan 2018, section 2.5.2).
#pragma once

#include <vector>

#include "process/calibration/methods/fractional_design.h"

namespace diefill::process::calibration {

/// Low and high level of a factor, in its unit.
struct FactorRange {
  double low = 0, high = 1;
};

/// The coefficient of a pair's product.
struct PairTerm {
  FactorPair pair;
  double coefficient = 0;  ///< b_k = E_k / (Delta_i Delta_j)
};

/// y = mean + sum b_i (xi_i - centre_i) + sum b_k (xi_i - centre_i) (xi_j - centre_j). The printed factor 2
/// before the pairs belongs to another definition of their effect; with the printed one it is 1.
struct EffectModel {
  double mean = 0;                  ///< over the corners of the design
  std::vector<double> centre;       ///< of each factor's range
  std::vector<double> coefficient;  ///< b_i = E_i / (high - low)
  std::vector<PairTerm> pairs;
};

/// One pair for each alias string of pairs alone, that with the larger product of main effects: the design
/// measures only their sum. Strings with a main effect are left to it. `responses`: one value a run.
std::vector<FactorPair> pairs_to_fit(const FractionalDesign& design, const std::vector<double>& responses);

/// E_k = (mean at ++ less mean at -+) less (mean at +- less mean at --), as printed.
double pair_effect(const FractionalDesign& design, const std::vector<double>& responses,
                   const FactorPair& pair);

/// The model with these pairs. Throws std::invalid_argument where ranges or responses are too few, or a range
/// is empty.
EffectModel fit_effects(const FractionalDesign& design, const std::vector<FactorRange>& ranges,
                        const std::vector<double>& responses, const std::vector<FactorPair>& pairs);

/// The quantity at `setting`, factor by factor in its unit, with or without interactions.
double predicted(const EffectModel& model, const std::vector<double>& setting, bool interactions = true);

/// Whether all responses are above zero, or all below: fractions of them then mean something.
bool have_one_sign(const std::vector<double>& responses);

/// Mean over runs of |predicted - simulated| / |simulated| in percent (Kottlan 2018, Tables 9, 19 and 20);
/// NaN unless have_one_sign().
double prediction_error(const EffectModel& model, const std::vector<std::vector<double>>& settings,
                        const std::vector<double>& responses, bool interactions = true);

/// The settings of all runs of a design.
std::vector<std::vector<double>> settings_of(const FractionalDesign& design,
                                             const std::vector<FactorRange>& ranges);

}  // namespace diefill::process::calibration
