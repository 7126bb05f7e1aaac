// A filled cavity in one line, for the press operator.
#pragma once

#include <string>

#include "process/results/fill_result.h"

namespace diefill::process {

/// How full the result's cavity is and what it holds, where the powder in it is loosest, and how far its
/// surface stands below the fill plane; from the figures of add_real_mass and measure_figures. A part of the
/// cavity counts as loose where its mean solid fraction is below the mean of the cavity by more than 2 % and
/// by more than two standard errors of the part; parts with fewer than kMinGrains grains do not count, and
/// are named where they hold powder.
std::string verdict(const results::FillResult& result);

/// Where the powder is loosest in that sense: "where the shoe leaves (solid fraction 0.28, mean 0.32)", and
/// which parts with powder it could not be compared with, for want of grains; empty where no part is, or
/// `known` is set to false where there are too few grains to determine it.
std::string loosest_part(const results::FillResult& result, bool& known);

}  // namespace diefill::process
