// Standard deviations of measured values: which column of a table holds them, and which are possible.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "process/measured_data/measured_table.h"

namespace diefill::process {

/// By its name, with or without capitals: "deviation" anywhere in it, or one of the words std, stdev, stddev,
/// sd, error, uncertainty and sigma; a sigma in a unit of stress is a value.
bool is_deviation(const MeasuredColumn& column);

/// The column of deviations, taken out; nothing where none is called so. Throws SceneError for a second one,
/// and for deviations that are relative.
std::optional<MeasuredColumn> taken_deviation(std::vector<MeasuredColumn>& columns);

/// Into the unit of the values. Throws SceneError for a unit of another dimension.
void convert_deviation(MeasuredColumn& deviation, const MeasuredColumn& value);

/// Throws SceneError for a deviation that no measurement of these values has: chi^2 would be without bounds
/// or without meaning.
void check_deviations(const MeasuredTable& table);

/// That most deviations exceed the values, as they do where the two are swapped; empty where they do not.
std::string remark_on_deviations(const MeasuredTable& table);

}  // namespace diefill::process
