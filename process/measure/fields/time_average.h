// Averages over time: the grains of several instants as if they had been there at once.
#pragma once

#include "process/results/fill_result.h"

namespace diefill::process {

/// Powder of the kept instants (FillResult::instants) from `from` to `to` (s, both included) and of the end
/// where it lies between, all together: a Gaussian average (Bierwisch 2009, Eq. 2.27) or a histogram of it is
/// one over space and time in the laboratory's frame, as the fields near a slit of section 4.1.8. Solid
/// fractions are measured at each instant. Tools and time are those of the last; figures, maps, sections,
/// profiles and contact stresses are left out. `instants` says how many were found (may be null). Throws
/// std::invalid_argument, naming what there is, where fewer than two are found.
results::FillResult time_average(const results::FillResult& result, double from, double to,
                                 std::size_t* instants = nullptr);

}  // namespace diefill::process
