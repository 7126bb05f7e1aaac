// A parameter that is to be found: a key of a scene with the range to search.
#pragma once

#include <string>
#include <vector>

#include "process/input/table_reader.h"

namespace diefill::process::calibration {

/// Numbers are in `unit`, as the file spells it. The unit cube runs from `from` to `to`, evenly or evenly in
/// the logarithm.
struct ParameterRange {
  std::string key;
  std::string unit;  ///< "1" for plain numbers
  double from = 0, to = 1;
  bool logarithmic = false;
  std::string where_from = {}, where_to = {};  ///< places of its ends in the file; begin messages

  double value_at(double place) const;
  double place_of(double value) const;
  /// A line of TOML that sets the key, such as `powder.work_of_adhesion = "0.005 J/m^2"`.
  std::string assignment(double place) const;
};

/// All [[parameter]] tables. Throws SceneError for keys outside [powder], [contact] and [walls], keys given
/// twice, ends in different units or in the wrong order, and a logarithmic range that does not begin above 0.
std::vector<ParameterRange> read_parameters(TableReader& document);

}  // namespace diefill::process::calibration
