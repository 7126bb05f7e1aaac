// Quantities as engineers write them ("1.88 mm", "0.2 m/s") turned into SI numbers by udunits2, with the
// dimension checked.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace diefill::process {

/// What kind of quantity a key holds.
enum class Dimension {
  length,
  time,
  velocity,
  acceleration,
  mass,
  density,
  pressure,
  work_of_adhesion,
  viscosity,
  damping_over_radius,
  angle,
  angular_velocity,
  frequency,
  force,
  torque,
  mass_rate,
};

/// A quantity that cannot be read. The message continues `found "...", `: what is needed, with an example.
struct UnitError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The value of `text` (a decimal number followed by a unit) in SI units; angles in radian. Accepts every
/// unit that udunits2 knows, and "deg". Throws UnitError for a missing number or unit, an unknown unit,
/// another dimension (also a reciprocal one, such as Hz for a time) and values that are not finite. `example`
/// stands in the message; when empty, an example of the dimension does.
double parse_quantity(std::string_view text, Dimension dimension, std::string_view example = {});

/// Such as "a length".
std::string description(Dimension dimension);

/// A quantity of that dimension as a user would write it, such as "0.94 mm".
std::string_view example_of(Dimension dimension);

/// `value` with as many digits as a person needs (six at most), such as "0.2".
std::string number_text(double value);

}  // namespace diefill::process
