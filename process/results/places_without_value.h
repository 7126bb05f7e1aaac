// Places of a field that have no value, and why: encoded in Field2D::value itself.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

namespace diefill::results {

/// Both are NaN like that of "no powder", so that averages leave all of them out; the last
/// bits distinguish them, also in files.

/// Stands where there is powder of which no value is known, as where the cells of all its grains are open.
inline double unvalued_powder() {
  return std::bit_cast<double>(std::uint64_t{0x7ff8000000000001});
}

/// Stands where there is a tool.
inline double inside_tool() {
  return std::bit_cast<double>(std::uint64_t{0x7ff8000000000002});
}

/// True for unvalued_powder() alone, not for numbers and other NaN.
inline bool is_unvalued_powder(double value) {
  return std::isnan(value) && (std::bit_cast<std::uint64_t>(value) & 3) == 1;
}

/// True for inside_tool() alone.
inline bool is_inside_tool(double value) {
  return std::isnan(value) && (std::bit_cast<std::uint64_t>(value) & 3) == 2;
}

}  // namespace diefill::results
