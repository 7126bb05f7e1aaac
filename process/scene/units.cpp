#include "process/scene/units.h"

#include <udunits2.h>

#include <array>
#include <charconv>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <memory>

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

struct FreeUnit {
  void operator()(ut_unit* unit) const { ut_free(unit); }
};
struct FreeSystem {
  void operator()(ut_system* system) const { ut_free_system(system); }
};
struct FreeConverter {
  void operator()(cv_converter* converter) const { cv_free(converter); }
};
using Unit = std::unique_ptr<ut_unit, FreeUnit>;

/// udunits2 reports on stderr by itself; a wrong unit is the user's to hear of once, in our own words.
int say_nothing(const char*, va_list) {
  return 0;
}

ut_system* units() {
  static const std::unique_ptr<ut_system, FreeSystem> system = [] {
    ut_set_error_message_handler(say_nothing);
    std::unique_ptr<ut_system, FreeSystem> made(ut_read_xml(nullptr));
    if (!made)
      throw std::runtime_error("the database of units of udunits2 cannot be read; install libudunits2-data");
    const Unit degree(ut_parse(made.get(), "degree", UT_UTF8));
    ut_map_name_to_unit("deg", UT_UTF8, degree.get());
    return made;
  }();
  return system.get();
}

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

struct Split {
  double number = 0;
  std::string unit;
};

/// Parts number and unit without regard to the locale.
Split split(std::string_view text, const std::string& needed) {
  text = trimmed(text);
  if (!text.empty() && text.front() == '+') text.remove_prefix(1);
  Split result;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), result.number);
  if (error == std::errc::result_out_of_range || (error == std::errc() && !std::isfinite(result.number))) {
    throw UnitError("the number is not finite; " + needed);
  }
  if (error != std::errc()) throw UnitError("it does not begin with a number; " + needed);
  std::string_view rest(end, static_cast<std::size_t>(text.data() + text.size() - end));
  if (!rest.empty() && rest.front() == ',') throw UnitError("write a decimal point, not a comma; " + needed);
  result.unit = trimmed(rest);
  return result;
}

/// Only an equal dimension will do: udunits2 itself would also turn Hz into s, being reciprocal.
bool same_dimension(const ut_unit* unit, const ut_unit* wanted) {
  const Unit quotient(ut_divide(unit, wanted));
  const Unit one(ut_get_dimensionless_unit_one(units()));
  return quotient && ut_are_convertible(unit, wanted) != 0 &&
         ut_are_convertible(quotient.get(), one.get()) != 0;
}

}  // namespace

double parse_quantity(std::string_view text, Dimension dimension, std::string_view example) {
  const DimensionEntry& kind = entry(dimension);
  const std::string needed = std::string(kind.words) + " with its unit is needed, such as \"" +
                             std::string(example.empty() ? kind.example : example) + '"';
  const Split parts = split(text, needed);
  if (parts.unit.empty()) throw UnitError(needed);
  const Unit wanted(ut_parse(units(), kind.si_unit, UT_UTF8));
  const Unit unit(ut_parse(units(), parts.unit.c_str(), UT_UTF8));
  if (!unit) throw UnitError("the unit \"" + parts.unit + "\" is not known; " + needed);
  if (!same_dimension(unit.get(), wanted.get())) {
    throw UnitError("\"" + parts.unit + "\" is not a unit of " +
                    (std::string(kind.words).substr(kind.words[1] == 'n' ? 3 : 2)) + "; " + needed);
  }
  const std::unique_ptr<cv_converter, FreeConverter> converter(ut_get_converter(unit.get(), wanted.get()));
  const double value = cv_convert_double(converter.get(), parts.number);
  if (!std::isfinite(value)) throw UnitError("the number is not finite; " + needed);
  return value;
}

std::string in_words(Dimension dimension) {
  return entry(dimension).words;
}

std::string_view example_of(Dimension dimension) {
  return entry(dimension).example;
}

std::string number_in_words(double value) {
  std::array<char, 32> buffer{};
  const int length = std::snprintf(buffer.data(), buffer.size(), "%g", value);
  return {buffer.data(), static_cast<std::size_t>(length)};
}

}  // namespace diefill::process
