// What a calibration has found, in numbers and words: measured against simulated, intervals, profiles, maps,
// correlations, and which further measurement would help.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "process/calibration/fit.h"
#include "process/calibration/methods/curve_residual.h"
#include "process/results/studies/calibration.h"

namespace diefill::process::calibration {

/// Everything but command, version and why the search ended.
results::Calibration calibration_results(const CalibrationPlan& plan, const SimulatedPoints& simulated,
                                         const std::optional<Fit>& fit);

/// The parts of it: parameters with profiles, correlations and samples; measurements; maps; which further
/// measurement would help, with a remark on those of which that is not known.
void add_parameters(results::Calibration& account, const CalibrationPlan& plan,
                    const std::optional<Fit>& fit);
void add_measurements(results::Calibration& account, const CalibrationPlan& plan,
                      const SimulatedPoints& simulated, const std::optional<Fit>& fit);
void add_maps(results::Calibration& account, const CalibrationPlan& plan, const Fit& fit);
void add_worth(results::Calibration& account, const CalibrationPlan& plan, const SimulatedPoints& simulated,
               const Fit& fit);

/// A measurement's curve through these of its values; nothing where it has none.
std::optional<MeasuredCurve> measured_curve(const Measurement& measurement,
                                            const std::vector<std::size_t>& places);

/// Whether chance explains the chi^2 of so many data (1 %); the parameters have used up as many of them.
/// Where none are left, a region without a limit reaches chi^2 0: the limit of one datum tells whether a
/// range ends before that, and agreement proves nothing.
bool explained_by_chance(double chi_square, std::size_t data, std::size_t parameters);

/// What the simulated value of a check may differ by: the deviations of measurement and runs, or also what
/// the region of parameters leaves open.
enum class CheckedAgainst { deviation, region };

/// chi^2 of the values of a check that have a simulated one; NaN where none has.
double chi_square_of_check(const results::CalibratedMeasurement& row, CheckedAgainst against);

/// Whether a measurement that was kept for checking is predicted, in a sentence: where chance would exceed
/// its chi^2 in 1 % of cases or more, if the variance over seeds has the degrees of freedom of
/// CalibrationDatum::freedom. Where it has none it counts as 0, and the sentence says so.
std::string check_verdict(const results::CalibratedMeasurement& row);
/// The same without the measurement's name: "is predicted within its deviation".
std::string check_outcome(const results::CalibratedMeasurement& row);

/// Whether finer `grains` give other values than those fitted, in a sentence: by more than the measured
/// deviation and the scatter over `seeds` runs explain (1 %).
std::string finer_verdict(const results::CalibratedMeasurement& row, const std::string& grains, int seeds);

}  // namespace diefill::process::calibration
