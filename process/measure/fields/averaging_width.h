// Width of the Gaussian of all fields: the usual one, the limits within which a field shows something, and
// the one that a result was measured with.
#pragma once

#include "process/results/fill_result.h"

namespace diefill::process {

/// m: sigma of Eq. 2.27 where none is given, the larger of 0.5 mm (Bierwisch 2009, Figs. 3.6, 4.12) and d/2.
double default_averaging_width(double grain_diameter);

/// m: a tenth of a grain. Below, nearly every point lies between grains and has no value.
double least_averaging_width(double grain_diameter);

/// m: the largest edge of the cavity (m; of all powder where there is no cavity), or the default where that
/// is more. Above, the field is the same everywhere.
double largest_averaging_width(double grain_diameter, double largest_edge);

/// m: with which the fields of `result` were averaged; 0 where it has none.
double measured_averaging_width(const results::FillResult& result);

/// The same, at least a tenth of a grain; the default where it has none.
double usual_averaging_width(const results::FillResult& result);

}  // namespace diefill::process
