#include "process/input/units.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <memory>

#include "process/input/shown_value.h"
#include "process/input/unit_text.h"
#include "process/results/trimmed.h"

namespace diefill::process {
namespace {

struct DimensionEntry {
  Dimension dimension;
  const char* words;
  const char* si_unit;
  const char* example;
};

constexpr std::array<DimensionEntry, 16> kDimensions = {{
    {Dimension::length, "a length", "m", "0.94 mm"},
    {Dimension::time, "a time", "s", "50 ms"},
    {Dimension::velocity, "a velocity", "m/s", "0.2 m/s"},
    {Dimension::acceleration, "an acceleration", "m/s^2", "10 m/s^2"},
    {Dimension::mass, "a mass", "kg", "0.0763 mg"},
    {Dimension::density, "a density", "kg/m^3", "3.0 g/cm^3"},
    {Dimension::pressure, "a pressure", "Pa", "10 MPa"},
    {Dimension::work_of_adhesion, "a work of adhesion per area or force per length", "J/m^2", "0.005 J/m^2"},
    {Dimension::viscosity, "a viscosity", "Pa s", "2e-5 Pa s"},
    {Dimension::damping_over_radius, "a damping over radius", "Pa s/m", "1e6 Pa s/m"},
    {Dimension::angle, "an angle", "rad", "90 deg"},
    {Dimension::angular_velocity, "an angular velocity", "rad/s", "60 rpm"},
    {Dimension::frequency, "a frequency", "Hz", "32 Hz"},
    {Dimension::force, "a force", "N", "5 N"},
    {Dimension::torque, "a torque or energy", "N m", "0.02 N m"},
    {Dimension::mass_rate, "a mass rate or damping coefficient", "kg/s", "20 g/s"},
}};

const DimensionEntry& entry(Dimension dimension) {
  for (const DimensionEntry& candidate : kDimensions) {
    if (candidate.dimension == dimension) return candidate;
  }
  throw std::logic_error("a dimension without an entry in kDimensions");
}

struct FreeConverter {
  void operator()(cv_converter* converter) const { cv_free(converter); }
};

/// "2820" of "2 820 um": digits in groups of three, as many write thousands. Empty for anything else.
std::string joined_thousands(std::string_view text) {
  std::string digits;
  std::size_t group = 0;
  for (const char letter : text) {
    const bool digit = letter >= '0' && letter <= '9';
    if (!digit && letter != ' ') break;
    if (digit) {
      digits += letter;
      ++group;
    } else if (group > 3 || (digits.size() > group && group != 3)) {
      return {};
    } else {
      group = 0;
    }
  }
  return group == 0 || group == 3 ? digits : "";
}

struct Split {
  double number = 0;
  std::string unit;
};

/// Parts number and unit without regard to the locale.
Split split(std::string_view text, const std::string& needed) {
  text = results::trimmed(text);
  if (!text.empty() && text.front() == '+') text.remove_prefix(1);
  Split result;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), result.number);
  if (error == std::errc::result_out_of_range || (error == std::errc() && !std::isfinite(result.number))) {
    throw UnitError("the number is not finite; " + needed);
  }
  if (error != std::errc()) throw UnitError("it does not begin with a number; " + needed);
  std::string_view rest(end, static_cast<std::size_t>(text.data() + text.size() - end));
  if (!rest.empty() && rest.front() == ',') throw UnitError("write a decimal point, not a comma; " + needed);
  result.unit = results::trimmed(rest);
  if (!result.unit.empty() && result.unit.front() >= '0' && result.unit.front() <= '9') {
    const std::string joined = joined_thousands(text);
    if (joined.size() > 3) throw UnitError("write the number without spaces, as " + joined + "; " + needed);
  }
  return result;
}

/// Only an equal dimension will do: udunits2 itself would also turn Hz into s, its reciprocal, and rpm into
/// Hz, taking an angle for a number.
bool same_dimension(const ParsedUnit& given, const ut_unit* wanted) {
  const Unit quotient(ut_divide(given.unit.get(), wanted));
  const Unit one(ut_get_dimensionless_unit_one(unit_system()));
  if (!quotient || ut_are_convertible(given.unit.get(), wanted) == 0 ||
      ut_are_convertible(quotient.get(), one.get()) == 0)
    return false;
  return makeup_of(quotient.get()).angle == 0 && given.angles == makeup_of(wanted).angle;
}

ParsedUnit unit_in(const std::string& text, const std::string& needed) {
  try {
    return parse_unit(text);
  } catch (const UnitTextError& error) {
    throw UnitError(error.what() + ("; " + needed));
  }
}

}  // namespace

double parse_quantity(std::string_view text, Dimension dimension, std::string_view example) {
  const DimensionEntry& kind = entry(dimension);
  const std::string needed = "expected " + std::string(kind.words) + " with its unit, such as \"" +
                             std::string(example.empty() ? kind.example : example) + '"';
  const Split parts = split(as_typed(text), needed);
  if (parts.unit.empty()) throw UnitError(needed);
  const Unit wanted(ut_parse(unit_system(), kind.si_unit, UT_UTF8));
  const ParsedUnit given = unit_in(parts.unit, needed);
  if (!same_dimension(given, wanted.get())) {
    throw UnitError("\"" + one_line(parts.unit) + "\" is not a unit of " +
                    (std::string(kind.words).substr(kind.words[1] == 'n' ? 3 : 2)) + "; " + needed);
  }
  const std::unique_ptr<cv_converter, FreeConverter> converter(
      ut_get_converter(given.unit.get(), wanted.get()));
  const double value = cv_convert_double(converter.get(), parts.number);
  if (!std::isfinite(value)) throw UnitError("the number is not finite; " + needed);
  return value;
}

std::string description(Dimension dimension) {
  return entry(dimension).words;
}

std::string_view example_of(Dimension dimension) {
  return entry(dimension).example;
}

std::string number_text(double value) {
  std::array<char, 32> buffer{};
  const int length = std::snprintf(buffer.data(), buffer.size(), "%g", value);
  return {buffer.data(), static_cast<std::size_t>(length)};
}

}  // namespace diefill::process
