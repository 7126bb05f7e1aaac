// Single numbers that describe how evenly a die is filled. Each is a function from results to named figures,
// which appear in report.json and can be compared between filling strategies.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "process/results/fill_result.h"

namespace diefill::process {

using Figures = std::map<std::string, double>;

/// Measures one thing of a result with measured solid fractions and fields. Adds nothing where the thing does
/// not exist, such as an azimuth in a cavity that is no ring, and NaN where too little powder is there.
using FigureMeasure = void (*)(const results::FillResult& result, Figures& figures);

/// All of them: to add one, a file of its own and its line in figures.cpp.
const std::vector<FigureMeasure>& figure_measures();

/// Adds what all of them measure to `result.figures`; nothing where there is no cavity.
void measure_figures(results::FillResult& result);

/// `solid_fraction_top_minus_bottom`: mean solid fraction of the upper third less that of the lower third.
/// Thirds of the height of the powder above the cavity floor where the grain lies; means are solid volume
/// over cell volume of the counted grains (counted_grains.h).
void top_to_bottom(const results::FillResult& result, Figures& figures);

/// Rings: amplitude of the first two harmonics of the solid fraction over the azimuth, and where they are at
/// their largest. phi = a_0 + sum_n A_n cos(n (azimuth - azimuth_n)), n = 1, 2, fitted to the counted grains
/// by least squares weighted by cell volume, so that a_0 of an even filling is solid over cell volume.
/// `solid_fraction_harmonic_<n>` is A_n; `solid_fraction_harmonic_<n>_azimuth_deg` is azimuth_n in 0 to 360/n
/// deg, counter-clockwise from where the shoe first arrives.
void azimuthal_harmonics(const results::FillResult& result, Figures& figures);

/// Other cavities: phi = a_0 + B_1 cos(pi s) + B_2 cos(2 pi s), fitted in the same way; s goes from 0 at the
/// end of the cavity where the shoe first arrives to 1 at the opposite one (along x for a shoe that moves
/// along x). `solid_fraction_along_travel_1` is B_1, positive where the arrival end is denser than the far
/// end; `solid_fraction_along_travel_2` is B_2, positive where both ends are denser than the middle.
void travel_harmonics(const results::FillResult& result, Figures& figures);

/// `solid_fraction_field_std`: standard deviation of the averaged field (Bierwisch 2009, Eq. 2.27, with the
/// width of the result's fields) over the counted grains. Unlike the spread of single grains' cells it has
/// little of the disorder that every random packing has, and shows what differs from place to place.
void field_evenness(const results::FillResult& result, Figures& figures);

/// `fill_height_mm`: mean height of the powder surface above the cavity floor. Rings: mean over azimuth of
/// the profile "fill level". Other cavities: mean of the map "fill level". Where there is no powder the
/// height is zero.
void fill_height(const results::FillResult& result, Figures& figures);

/// Where grains are of several sizes (segregation.h), of those in the cavity, means weighted by mass:
/// `mean_grain_diameter_filled_mm`, and `mean_grain_diameter_all_mm` of all powder there is;
/// `mean_grain_diameter_top_minus_bottom_mm`, upper less lower third of the grains; `mixing_index_height` and
/// `mixing_index_azimuth` (rings) or `mixing_index_travel`: about 1 for powder as well mixed as by chance, 0
/// where each size lies on its own.
void size_segregation(const results::FillResult& result, Figures& figures);
/// Of several powders: share of the first one's mass in the cavity and in all; mixing indices as above, with
/// 0 where powders lie apart.
void powder_segregation(const results::FillResult& result, Figures& figures);

}  // namespace diefill::process
