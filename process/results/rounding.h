// Numbers with only the digits that their scatter allows.
#pragma once

#include <string>

namespace diefill::results {

/// Whether a difference of sums of such a size is nothing but their rounding.
bool is_rounding(double difference, double size);

/// Decimals that a scatter leaves: up to its first digit, or its second where the first is 1 or 2. Negative:
/// tens, hundreds. `scatter` is positive.
int decimals_of_scatter(double scatter);

/// The same for `value`, which has five significant digits at most however small its scatter is.
int decimals_of_scatter(double scatter, double value);

/// `value` rounded to `decimals`; "0.31" for 2, "40" for -1.
std::string at_decimals(double value, int decimals);

/// "0.31 ± 0.05", both to the decimals that the scatter leaves; the value alone with `digits` significant
/// digits where the scatter is not known. Empty for a value that is no number.
std::string with_scatter(double value, double scatter, int digits = 3);

/// `value` with `digits` significant digits and no exponent where that stays short.
std::string in_significant_digits(double value, int digits);

/// " mm" to stand after a number; nothing for plain numbers, whose unit is "1" or empty.
std::string unit_behind(const std::string& unit);

/// A share as "42 %", in whole percent.
std::string whole_percent(double share);

/// A mass in kg as "3.12 g" or "45.6 mg", with `digits` significant digits.
std::string mass_text(double mass, int digits = 3);

}  // namespace diefill::results
