// From measured costs and values to errors, the floor due to seeds, the Pareto front, and the recommended
// setting.
#pragma once

#include <optional>

#include "process/results/studies/tradeoff.h"

namespace diefill::process {

/// Pooled scatter over seeds of a quantity, a fraction of `scale`: root of the sum of squares over all
/// settings over the sum of their (seeds - 1). NaN where no setting has two seeds.
struct PooledScatter {
  double scatter = 0;
  double freedom = 0;  ///< sum of (seeds - 1)
};
PooledScatter pooled_scatter(const std::vector<results::TradeoffValue>& values, double scale);

/// Error that a setting of `seeds` runs shows by chance alone against a reference of `of_reference` runs, in
/// one case of twenty at most: Student's t_{0.975} at the pooled freedom times the scatter times
/// sqrt(1 / seeds + 1 / of_reference); the latter is 0 for a target, which has no runs (nothing). NaN where
/// the scatter is not known, or one of the two has no runs.
double error_floor(const PooledScatter& pooled, std::uint64_t seeds,
                   std::optional<std::uint64_t> of_reference);

/// Widest floor, a fraction, within which a setting is still recommended where the tolerance is smaller: what
/// scatters more cannot distinguish settings.
inline constexpr double kWidestFloor = 0.1;

/// Least number of seeds, as many for each of `settings` settings, at which the floor of this scatter is at
/// most `wanted`; 0 where a thousand are not enough or the scatter is not known.
std::uint64_t seeds_for(const PooledScatter& pooled, std::size_t settings, double wanted, bool target);

/// Indices of the points that no other beats: none costs less (or as much) with a smaller (or as small)
/// error. Cheapest first; points with a NaN stay out; of equal points the first is on it.
std::vector<std::size_t> pareto_front(const std::vector<double>& cost, const std::vector<double>& error);

/// Index of the reference setting: the costliest of those that are the base or nothing but finer than it
/// (`finer` > 0) and have results, of those without a failed run where there are such; the number of settings
/// where none has results.
std::size_t reference_setting(const std::vector<results::TradeoffPoint>& points,
                              const std::vector<int>& finer);

/// Fills in everything that follows from the values: references (those of point `reference` unless targets),
/// scatter and floors, errors, what is beyond its limit, Pareto front, and the recommendation: the cheapest
/// setting that is acceptable. A setting with a failed run is neither on the front nor recommended. Where
/// seeds scatter too much (distinguishes_settings()) nothing is, and the advice says how many seeds would do;
/// nor is a setting with too few seeds of its own (has_enough_seeds()).
void evaluate(results::Tradeoff& tradeoff, std::size_t reference);

/// Whether none of the setting's runs failed, its error is known, and every quantity that decides is within
/// the larger of its own floor and the tolerance. Asks for an evaluated setting.
bool is_acceptable(const results::TradeoffPoint& point);

/// Whether the setting is the reference, or none of its quantities that decide has a floor of its own above
/// both kWidestFloor and the tolerance. Asks for an evaluated setting.
bool has_enough_seeds(const results::Tradeoff& tradeoff, const results::TradeoffPoint& point);

/// Whether no quantity that decides has a floor above both kWidestFloor and the tolerance. Asks for an
/// evaluated tradeoff.
bool distinguishes_settings(const results::Tradeoff& tradeoff);

}  // namespace diefill::process
