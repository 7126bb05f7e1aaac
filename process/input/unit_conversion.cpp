#include "process/input/unit_conversion.h"

#include <charconv>
#include <cmath>

#include "process/input/shown_value.h"
#include "process/input/unit_text.h"
#include "process/results/trimmed.h"

namespace diefill::process {
namespace {

bool is_plain(std::string_view unit) {
  return unit.empty() || unit == "1" || unit == "-" || unit == "%";
}

ParsedUnit parsed(std::string_view unit) {
  if (is_plain(unit)) return {Unit(ut_get_dimensionless_unit_one(unit_system())), 0};
  try {
    return parse_unit(unit);
  } catch (const UnitTextError& error) {
    throw UnitError(error.what());
  }
}

struct FreeConverter {
  void operator()(cv_converter* converter) const { cv_free(converter); }
};

}  // namespace

double unit_factor(std::string_view from, std::string_view to) {
  from = results::trimmed(from);
  to = results::trimmed(to);
  const ParsedUnit given = parsed(from), wanted = parsed(to);
  // udunits2 would also turn Hz into s and take an angle for a number.
  const Unit quotient(ut_divide(given.unit.get(), wanted.unit.get()));
  const Unit one(ut_get_dimensionless_unit_one(unit_system()));
  const bool same = quotient && ut_are_convertible(quotient.get(), one.get()) != 0 &&
                    makeup_of(quotient.get()).angle == 0 && given.angles == wanted.angles;
  if (!same)
    throw UnitError("\"" + one_line(from) + "\" does not have the dimension of \"" + one_line(to) + "\"");
  const std::unique_ptr<cv_converter, FreeConverter> converter(
      ut_get_converter(given.unit.get(), wanted.unit.get()));
  const double hundredths = (from == "%" ? 0.01 : 1) / (to == "%" ? 0.01 : 1);
  return cv_convert_double(converter.get(), 1) * hundredths;
}

bool has_same_dimension(std::string_view one, std::string_view other) {
  try {
    unit_factor(one, other);
    return true;
  } catch (const UnitError&) {
    return false;
  }
}

NumberWithUnit number_with_unit(std::string_view text) {
  const std::string typed = as_typed(text);
  std::string_view rest = results::trimmed(typed);
  if (!rest.empty() && rest.front() == '+') rest.remove_prefix(1);
  NumberWithUnit read;
  const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), read.number);
  if (error != std::errc() || !std::isfinite(read.number))
    throw UnitError("it does not begin with a number; expected a number with its unit, such as \"12.1 g\"");
  const std::string_view unit = results::trimmed(rest.substr(static_cast<std::size_t>(end - rest.data())));
  read.unit = unit.empty() ? "1" : std::string(unit);
  parsed(read.unit);
  return read;
}

}  // namespace diefill::process
