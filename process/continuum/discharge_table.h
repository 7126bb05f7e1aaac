// Measured discharges as a CSV file, with units in its heading.
#pragma once

#include <filesystem>
#include <optional>

#include "process/continuum/discharge_fit.h"

namespace diefill::process::continuum {

/// What the command line says of all points, in place of a column that says it of each. SI units.
struct CommonToAll {
  std::optional<double> density, width, length, shoe_length, grain_diameter;
  std::optional<double> opened;  ///< s, when the slit opened; times count from then, earlier lines do not
  std::optional<double> until = std::nullopt;  ///< s, on the clock of `opened`; later lines do not count
};

/// Reads the table for a law. The first line names the columns with their units: `speed m/s` or `time s`,
/// `mass g` or `rate g/s`, and as wanted `error g` or `rate_error g/s`, `width mm` (or `diameter mm`),
/// `length mm`, `shoe_length mm`, `density g/cm^3`. Other columns are refused; also columns and parts of
/// `common` that the law does not take, and parts of `common` that have a column as well. The rate in a flow
/// probe's file counts for nothing. Empty lines and lines that begin with # are passed over. Throws
/// SceneError with file and line.
DischargeData read_discharge_table(const std::filesystem::path& file, DischargeLaw law,
                                   const CommonToAll& common);

/// The law that such a table is for, as its columns say: masses over speeds are for 5.17, masses over time
/// for the transient law, rates over diameters or widths for Beverloo's. Throws SceneError.
DischargeLaw law_for_table(const std::filesystem::path& file);

}  // namespace diefill::process::continuum
