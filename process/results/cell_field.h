// Values on the cells of a grid in three dimensions, Cartesian or cylindrical.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace diefill::results {

/// One value a cell. Cartesian: x, y, z in m. Cylindrical: radius in m from the cavity's axis, azimuth in deg
/// and height in m above the cavity's floor.
struct CellField {
  std::string quantity, unit;  ///< such as "solid volume", "m^3"
  bool cylindrical = false;
  std::array<std::vector<double>, 3> edges;  ///< rising cell boundaries along each coordinate
  std::vector<double> value;                 ///< the first coordinate runs fastest

  std::size_t cells(std::size_t axis) const { return edges[axis].empty() ? 0 : edges[axis].size() - 1; }
  std::size_t cell(std::size_t first, std::size_t second, std::size_t third) const {
    return (third * cells(1) + second) * cells(0) + first;
  }
  std::size_t size() const { return cells(0) * cells(1) * cells(2); }
};

}  // namespace diefill::results
