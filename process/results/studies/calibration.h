// A powder found from measurements: parameters with their uncertainty, measured against simulated, what the
// data cannot determine; and the effects of a screening. As calibration.json and .csv, and for reports.
#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "process/results/fill_result.h"

namespace diefill::results {

/// A parameter with its range and what the measurements say about it. Numbers are in `unit`.
struct CalibratedParameter {
  std::string key;   ///< path in a scene, such as "powder.friction"
  std::string unit;  ///< "1" for plain numbers
  double from = 0, to = 0;
  bool logarithmic = false;
  double best = 0;              ///< where the likelihood is largest; NaN: not known
  double lower = 0, upper = 0;  ///< interval that holds 90 % of what agrees with the data
  std::vector<double> profile_at,
      profile;  ///< misfit with the parameter held there and all others at their best
};

/// One measured value beside what is simulated. NaN: no value.
struct CalibrationDatum {
  double x = 0, second = 0;            ///< place of a profile or map, or the value of `over`
  double measured = 0, deviation = 0;  ///< with its standard deviation
  double simulated = 0;                ///< at the best parameters
  double uncertainty = 0;              ///< standard deviation of `simulated` from runs too few
  double scatter = 0;                  ///< of a run over seeds
  double lower = 0, upper = 0;         ///< over the region of parameters that agree
  /// At the best parameters with finer grains.
  double finer = std::numeric_limits<double>::quiet_NaN();
  /// Degrees of freedom that `scatter` of a check is estimated with; 0: it is not known. Not stored.
  double freedom = 0;
};

struct CalibratedMeasurement {
  std::string name, kind;  ///< kind: figure, profile or map
  bool fitted = true;      ///< false: kept for checking
  std::string quantity, unit;
  std::string x_name, x_unit, second_name, second_unit;  ///< empty where there is none
  std::vector<CalibrationDatum> data;
  double chi_square = 0;      ///< of its own data at the best parameters
  double residual = 0;        ///< epsilon^2 of Bierwisch 2009, Eq. 4.3, of a curve; NaN: no curve
  double left_out_error = 0;  ///< of its emulator; about 1 where it states its uncertainty truly
  std::string remark;         ///< such as that no parameters reach it; empty: none
};

/// One set of parameters that was simulated.
struct CalibrationPoint {
  std::string role;            ///< "start", "search", "best", "edge", "finer" or "screening"
  std::vector<double> values;  ///< in the parameters' units
  std::string state, reason;   ///< finished, failed or left out; why
  double chi_square = 0;       ///< of its own runs against the data; NaN: not all finished
  double core_seconds = 0;     ///< of all its runs
};

/// What one more measurement would do to the uncertainty.
struct MeasurementWorth {
  std::string name;
  double volume = 1;               ///< of the region afterwards over now
  std::vector<double> deviations;  ///< of each parameter, afterwards over now
};

/// One column of a two-level design: effects that it cannot separate.
struct ScreenedEffect {
  std::string string;          ///< such as "AB = CF"
  std::string words;           ///< the same with parameters' names
  bool main = false;           ///< has a main effect in it
  std::vector<double> values;  ///< one for each screened quantity, in its unit
};

/// A term of a regression over levels of -1 and 1: half an effect.
struct RegressionTerm {
  std::string letters;  ///< of a factor or a pair, such as "A" or "AB"
  double coefficient = 0;
};

/// A quantity of a screening.
struct ScreenedQuantity {
  std::string name, unit;
  double mean = 0, error = 0,
         margin = 0;  ///< standard error and 95 % half width of an effect; NaN: not known
  /// Percent, of the regression without and with interactions; NaN where the quantity is 0 or changes its
  /// sign.
  double error_without = 0, error_with = 0;
  std::vector<RegressionTerm> regression = {};  ///< besides the mean, which is its constant
  std::string error_source = {};                ///< where `error` comes from, as text
};

struct Screening {
  std::size_t runs = 0, resolution = 0;  ///< resolution 0: full factorial
  std::vector<std::string> letters, generators, words;
  std::string error_source;  ///< where standard errors come from, as text; of several, for which quantities
  std::vector<ScreenedQuantity> quantities;
  std::vector<ScreenedEffect> effects;
  std::vector<std::string> remarks = {};  ///< which quantities have no effects or no relative error, and why
};

struct Calibration {
  std::string title, command, program_version;
  std::string powder;        ///< start: name of its file
  std::string finer_grains;  ///< grain size of the check with finer grains; empty: none
  std::string grains;        ///< grain size and model, walls and stiffness that it was fitted with, as text
  std::vector<CalibratedParameter> parameters;
  std::vector<CalibratedMeasurement> measurements;
  std::vector<CalibrationPoint> points;
  std::vector<std::vector<double>> correlation;  ///< of the parameters over the region
  std::vector<std::vector<double>> samples;      ///< some parameters that agree, in their units
  /// Root of the misfit over the number of values, over two parameters, all others at their best. Misfit:
  /// chi^2 of the best powder plus what -2 ln(likelihood) is above its least value.
  std::vector<Field2D> maps;
  /// What `maps` have at the edge of the region that holds 90 %; NaN: not known. Not stored.
  double map_edge = std::numeric_limits<double>::quiet_NaN();
  std::vector<Field2D> residual_maps;   ///< epsilon^2 of curves, the same way
  std::vector<MeasurementWorth> worth;  ///< what helps most first
  double chi_square = 0;                ///< at the best parameters
  std::size_t data = 0;                 ///< number of fitted values
  bool agrees = false;                  ///< chi^2 is one that chance explains (1 %)
  bool fitted = false;                  ///< false: too few runs, or a screening alone
  std::string stopped;                  ///< why the search ended, in a sentence
  std::size_t open_runs = 0;            ///< that are wanted but not finished
  std::vector<std::string> insights, remarks;
  Screening screening;  ///< runs 0: none
};

/// Names of the files that hold a calibration or screening in its directory, reports included.
const std::vector<std::string>& calibration_tables();

/// Writes `directory`/calibration.json, calibration.csv (measured against simulated), calibration_points.csv
/// and, of a screening, screening.csv, each whole or not at all. Throws ResultError.
void write_calibration(const std::filesystem::path& directory, const Calibration& calibration);

}  // namespace diefill::results
