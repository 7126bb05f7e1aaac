// Phrases that the statements of an estimate share.
#pragma once

#include <string>

#include "process/estimate/estimate.h"

namespace diefill::process::estimate {

inline constexpr const char* kFormula =
    "Bierwisch 2009, Eq. 5.17, on the local width of the opening (ours for shapes other than slits)";

/// "one crossing", "3 crossings"
std::string times(std::size_t crossings);
/// " with grains of 1.88 mm"
std::string with_grains(double diameter);
/// How a cavity is called in a sentence: "the cavity"; of several "cavity 2 at x = 12.5 mm, y = 0 mm".
std::string name_of(const Estimate& estimate, const OpeningEstimate& opening);
/// " at x = 12.5 mm, y = 0 mm"
std::string place_text(const Eigen::Vector2d& centre);

/// A share of what a cavity holds in percent, at most 100.
double percent_up_to_full(double share);

std::string error_text(const Estimate& estimate);
std::string valid_text(const Estimate& estimate);
/// What runs out of the scene's outlet, which it has, by formula.
std::string outlet_text(const Estimate& estimate);
/// The answer in one statement, with what it rests on.
std::string answer_text(const Estimate& estimate);
/// One line for a scene of several powders; empty for one of a single powder.
std::string powders_text(const Estimate& estimate);

/// The cavity that is emptiest, over what it holds; null: no shoe passes over one.
const OpeningEstimate* emptiest(const Estimate& estimate);

}  // namespace diefill::process::estimate
