// Refusals of law parameters: one clear line naming the parameter, what was found and what is allowed.
#pragma once

#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>

namespace diefill::engine::laws {

/// Throws std::invalid_argument(`reason`) unless `holds`.
inline void require(bool holds, const std::string& reason) {
  if (!holds) throw std::invalid_argument(reason);
}

/// Throws unless low <= value <= high.
inline void require_range(const char* name, double value, double low,
                          double high = std::numeric_limits<double>::max()) {
  if (value >= low && value <= high) return;
  std::ostringstream line;
  line << name << " is " << value << "; it must be at least " << low;
  if (high < std::numeric_limits<double>::max()) line << " and at most " << high;
  throw std::invalid_argument(line.str());
}

/// Throws unless value is positive and finite.
inline void require_positive(const char* name, double value) {
  if (value > 0 && value <= std::numeric_limits<double>::max()) return;
  std::ostringstream line;
  line << name << " is " << value << "; it must be positive";
  throw std::invalid_argument(line.str());
}

}  // namespace diefill::engine::laws
