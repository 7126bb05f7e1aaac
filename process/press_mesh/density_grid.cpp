#include "process/press_mesh/density_grid.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <sstream>
#include <stdexcept>

#include "geometry/grids/all_cores.h"
#include "process/measure/fields/gaussian_field.h"
#include "process/measure/measure.h"
#include "process/measure/tool_solids.h"
#include "process/measure/volumes/partial_volumes.h"

namespace diefill::process {
namespace {

/// The powder with the grains of the cavity alone.
results::PowderState powder_in_cavity(const results::FillResult& result) {
  const results::PowderState& all = result.powder;
  results::PowderState powder = all;
  powder.position.clear();
  powder.orientation.clear();
  powder.kind.clear();
  for (std::size_t k = 0; k < all.position.size(); ++k) {
    if (result.solid_fraction.in_cavity[k] == 0) continue;
    powder.position.push_back(all.position[k]);
    powder.orientation.push_back(all.orientation[k]);
    if (!all.monodisperse()) powder.kind.push_back(all.kind[k]);
  }
  return powder;
}

DensityGrid empty_grid(const results::FillResult& result, double spacing) {
  constexpr double kMaxCells = 2e7;
  if (!(result.cavity.volume > 0))
    throw std::invalid_argument("the result has no cavity for the grid to cover");
  const double margin = result.powder.largest_diameter();
  DensityGrid grid;
  grid.spacing = spacing;
  constexpr double kRounding = 1e-9;  // of a cell
  const Eigen::Vector3d size = result.cavity.upper_corner - result.cavity.lower_corner;
  const Eigen::Vector3d cells = (size / spacing - Eigen::Vector3d::Constant(kRounding)).array().ceil() +
                                2 * std::ceil(margin / spacing);
  if (cells.prod() > kMaxCells)
    throw std::invalid_argument("the grid would have more than 20 million cells; choose larger cells");
  grid.cells = cells.cast<int>();
  grid.origin = 0.5 * (result.cavity.lower_corner + result.cavity.upper_corner) - 0.5 * spacing * cells;
  return grid;
}

void fill_masses(DensityGrid& grid, const results::FillResult& result, double mass) {
  std::array<std::vector<double>, 3> edges;
  for (int axis = 0; axis < 3; ++axis)
    edges[static_cast<std::size_t>(axis)] =
        even_edges(grid.origin[axis], grid.origin[axis] + grid.spacing * grid.cells[axis], grid.cells[axis]);
  const results::CellField solid = cartesian_volumes(powder_in_cavity(result), edges);
  double sum = 0;
  for (const double volume : solid.value) sum += volume;
  if (!(sum > 0)) throw std::invalid_argument("the cavity holds no powder");
  for (int z = 0; z < grid.cells.z(); ++z)
    for (int y = 0; y < grid.cells.y(); ++y)
      for (int x = 0; x < grid.cells.x(); ++x)
        grid.mass.push_back(mass / sum *
                            solid.value[solid.cell(static_cast<std::size_t>(x), static_cast<std::size_t>(y),
                                                   static_cast<std::size_t>(z))]);
}

void fill_densities(DensityGrid& grid, const results::FillResult& result, const DensityRequest& request) {
  const GaussianField field(result.powder, result.solid_fraction, request.averaging_width);
  const double of_grains = solid_density(result);
  grid.solid_density = request.solid_density > 0 ? request.solid_density : of_grains;
  const double scale =
      request.mass / filled_mass(result.powder, result.solid_fraction) * of_grains / grid.solid_density;
  const auto solids = solids_of(result.tools);
  grid.relative.assign(grid.mass.size(), std::numeric_limits<double>::quiet_NaN());
  geometry::on_all_cores(
      static_cast<std::size_t>(grid.cells.y()) * static_cast<std::size_t>(grid.cells.z()),
      [&](std::size_t row) {
        const int y = static_cast<int>(row) % grid.cells.y();
        const int z = static_cast<int>(row) / grid.cells.y();
        for (int x = 0; x < grid.cells.x(); ++x) {
          const Eigen::Vector3d place = grid.middle(x, y, z);
          if (place.z() > result.cavity.upper_corner.z()) continue;
          if (std::any_of(solids.begin(), solids.end(),
                          [&](const auto& solid) { return solid.inside(place); }))
            continue;
          grid.relative[row * static_cast<std::size_t>(grid.cells.x()) + static_cast<std::size_t>(x)] =
              scale * field.at(place);
        }
      });
}

}  // namespace

DensityGrid density_grid(const results::FillResult& result, double spacing, const DensityRequest& request) {
  DensityGrid grid = empty_grid(result, spacing);
  fill_masses(grid, result, request.mass);
  fill_densities(grid, result, request);
  return grid;
}

std::string density_grid_csv(const DensityGrid& grid) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << std::setprecision(9) << "x [m],y [m],z [m],mass [kg],relative density [1],density [kg/m^3]\n";
  std::size_t cell = 0;
  for (int z = 0; z < grid.cells.z(); ++z)
    for (int y = 0; y < grid.cells.y(); ++y)
      for (int x = 0; x < grid.cells.x(); ++x, ++cell) {
        const bool known = std::isfinite(grid.relative[cell]);
        if (!known && !(grid.mass[cell] > 0)) continue;
        const Eigen::Vector3d place = grid.middle(x, y, z);
        text << place.x() << ',' << place.y() << ',' << place.z() << ',' << grid.mass[cell] << ',';
        if (known) text << grid.relative[cell];
        text << ',';
        if (known) text << grid.relative[cell] * grid.solid_density;
        text << '\n';
      }
  return text.str();
}

}  // namespace diefill::process
