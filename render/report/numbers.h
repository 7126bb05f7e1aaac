// Numbers of a report as people read them, and where a run's figures come from.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "process/results/fill_result.h"
#include "render/report/document.h"

namespace diefill::render::report {

/// `value` with `digits` significant digits, without an exponent where that stays short; "–" for NaN.
std::string in_digits(double value, int digits = 4);

/// The values of one quantity with one number of decimals, which leaves the largest `digits` significant
/// digits; "–" for NaN. Each as in_digits() has it where that would show another as zero, and where all are
/// whole numbers.
std::vector<std::string> in_one_format(const std::vector<double>& values, int digits = 4);

/// `value` of each row in one format, for a column of a table.
template <typename Rows, typename Value>
std::vector<std::string> column_of(const Rows& rows, Value value, int digits = 4) {
  std::vector<double> values;
  for (const auto& row : rows) values.push_back(std::invoke(value, row));
  return in_one_format(values, digits);
}

/// in_digits() with a unit after it; "–" alone for NaN.
std::string with_unit(double value, const std::string& unit, int digits = 4);

/// "name [unit]", as columns and axes have it; the name alone for plain numbers.
std::string with_unit_of(const std::string& name, const std::string& unit);

/// "1 h 02 min", "3 min 20 s", "12.3 s"; "–" for NaN.
std::string as_duration(double seconds);

/// A figure of the run by its name in report.json; NaN where the run has none.
double figure(const results::FillResult& result, const std::string& name);

/// Mean and, over several values, standard deviation of a sample; values that are NaN do not count.
struct Scatter {
  double mean, deviation;
  int count = 0;
};
Scatter scatter(const std::vector<double>& values);

/// "0.312 ± 0.004" with the digits that the deviation leaves, or the mean alone where there is one value.
std::string as_text(const Scatter& scatter, int digits = 4);

/// The same for a column of a table: means alone are in one format.
std::vector<std::string> as_texts(const std::vector<Scatter>& scatters, int digits = 4);

/// Takes away the columns in which no row has anything to say ("–").
void leave_out_empty_columns(Table& table);

}  // namespace diefill::render::report
