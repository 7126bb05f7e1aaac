#include "process/continuum/kinematic_model.h"

#include <stdexcept>

namespace diefill::process::continuum {

namespace {

constexpr int kDampedRows = 2;  ///< rows taken as two implicit half rows each (Rannacher's start)

/// Row k of the solid fraction, or one everywhere.
class Fractions {
 public:
  Fractions(const HopperGrid& grid, const std::vector<double>& values)
      : columns_(grid.columns), values_(values) {
    if (!values.empty() && values.size() != static_cast<std::size_t>(grid.rows + 1) * grid.columns)
      throw std::invalid_argument("a solid fraction is needed for each column and level of the hopper");
    for (const double value : values)
      if (!(value > 0)) throw std::invalid_argument("solid fractions must be above zero");
  }
  double at(int column, double row) const {
    if (values_.empty()) return 1;
    const int below = static_cast<int>(row);
    const double share = row - below;
    const double lower = values_[below * columns_ + column];
    return share > 0 ? (1 - share) * lower + share * values_[(below + 1) * columns_ + column] : lower;
  }

 private:
  int columns_;
  const std::vector<double>& values_;
};

/// B n at the borders between columns at a level, m; 0 at the walls.
std::vector<double> conductances(const HopperGrid& grid, const Fractions& fractions,
                                 const DiffusionLength& length, double row) {
  std::vector<double> result(grid.columns + 1, 0.0);
  for (int border = 1; border < grid.columns; ++border) {
    const double left = fractions.at(border - 1, row), right = fractions.at(border, row);
    result[border] = (length(left) * left + length(right) * right) / 2;
  }
  return result;
}

/// d/dx(B n dv/dx) of one column, 1/s.
double spread(const std::vector<double>& conductance, const std::vector<double>& v, int column,
              double spacing) {
  const int last = static_cast<int>(v.size()) - 1;
  const double right = column < last ? conductance[column + 1] * (v[column + 1] - v[column]) : 0;
  const double left = column > 0 ? conductance[column] * (v[column] - v[column - 1]) : 0;
  return (right - left) / (spacing * spacing);
}

/// Solves a symmetric tridiagonal system with positive diagonal that dominates (Thomas' algorithm); `right`
/// becomes the solution. beside[k] couples k - 1 and k.
void solve_tridiagonal(std::vector<double> diagonal, const std::vector<double>& beside,
                       std::vector<double>& right) {
  const int count = static_cast<int>(right.size());
  for (int k = 1; k < count; ++k) {
    const double factor = beside[k] / diagonal[k - 1];
    diagonal[k] -= factor * beside[k];
    right[k] -= factor * right[k - 1];
  }
  right[count - 1] /= diagonal[count - 1];
  for (int k = count - 2; k >= 0; --k) right[k] = (right[k] - beside[k + 1] * right[k + 1]) / diagonal[k];
}

/// Velocities one step `rise` (in rows) above `below`: n v grows by the spread, taken at the upper end by the
/// share `implicit` and at the lower end by the rest, with B n of the middle.
std::vector<double> row_above(const HopperGrid& grid, const Fractions& fractions,
                              const DiffusionLength& length, const std::vector<double>& below, double row,
                              double rise, double implicit) {
  const double h = grid.spacing_x(), k = rise * grid.spacing_z();
  const std::vector<double> conductance =
      conductances(grid, fractions, length, implicit < 1 ? row + rise / 2 : row + rise);
  std::vector<double> diagonal(grid.columns), beside(grid.columns, 0.0), result(grid.columns);
  const double weight = implicit * k / (h * h);
  for (int c = 0; c < grid.columns; ++c) {
    diagonal[c] = fractions.at(c, row + rise) + weight * (conductance[c] + conductance[c + 1]);
    if (c > 0) beside[c] = -weight * conductance[c];
    result[c] = fractions.at(c, row) * below[c] + (1 - implicit) * k * spread(conductance, below, c, h);
  }
  solve_tridiagonal(std::move(diagonal), beside, result);
  return result;
}

/// v_x = -B dv_z/dx at the borders of columns of one row (Bierwisch 2009, Eq. 5.7).
void add_horizontal(HopperFlow& flow, const Fractions& fractions, const DiffusionLength& length, int row) {
  const HopperGrid& grid = flow.grid;
  flow.horizontal.push_back(0);
  for (int border = 1; border < grid.columns; ++border) {
    const double b = (length(fractions.at(border - 1, row)) + length(fractions.at(border, row))) / 2;
    flow.horizontal.push_back(-b * (flow.vertical_at(border, row) - flow.vertical_at(border - 1, row)) /
                              grid.spacing_x());
  }
  flow.horizontal.push_back(0);
}

void require_grid(const HopperGrid& grid, const std::vector<double>& opening) {
  if (!(grid.width > 0) || !(grid.height > 0) || grid.columns < 2 || grid.rows < 1)
    throw std::invalid_argument("a hopper needs a width, a height, two columns and a row");
  if (opening.size() != static_cast<std::size_t>(grid.columns))
    throw std::invalid_argument("the opening needs one velocity for each column");
}

}  // namespace

HopperFlow solve_kinematic(const HopperGrid& grid, const std::vector<double>& opening,
                           const DiffusionLength& length, const std::vector<double>& fraction) {
  require_grid(grid, opening);
  const Fractions fractions(grid, fraction);
  HopperFlow flow{grid, opening, {}};
  std::vector<double> row = opening;
  for (int k = 0; k < grid.rows; ++k) {
    if (k < kDampedRows) {
      row = row_above(grid, fractions, length, row, k, 0.5, 1);
      row = row_above(grid, fractions, length, row, k + 0.5, 0.5, 1);
    } else {
      row = row_above(grid, fractions, length, row, k, 1, 0.5);
    }
    flow.vertical.insert(flow.vertical.end(), row.begin(), row.end());
  }
  for (int k = 0; k <= grid.rows; ++k) add_horizontal(flow, fractions, length, k);
  return flow;
}

}  // namespace diefill::process::continuum
