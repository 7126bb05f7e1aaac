#include "geometry/voronoi/voronoi.h"
#include "process/measure/cavity_position.h"
#include "process/measure/measure.h"
#include "process/measure/period.h"

namespace diefill::process {
namespace {

// A cell that reaches farther than this from a sphere (in grain diameters d) stands at a free surface. The
// cells of settled powder, even loose and cohesive, end well before.
constexpr double kReachOverDiameter = 1;

geometry::VoronoiRequest voronoi_request(const results::PowderState& powder,
                                         const std::vector<results::ToolState>& tools) {
  geometry::VoronoiRequest request;
  request.sphere_centres = powder.sphere_centres();
  request.spheres_per_grain = powder.sphere_offsets.size();
  if (!powder.kinds.spheres.empty()) request.grains_of_spheres = powder.grains_of_spheres();
  request.sphere_radius = powder.sphere_radius;
  if (!powder.equal_spheres()) request.sphere_radii = powder.radii_of_spheres();
  request.period = period_of(powder);
  request.largest_reach = kReachOverDiameter * powder.largest_diameter();
  for (const auto& tool : tools) {
    request.wall_centres.insert(request.wall_centres.end(), tool.wall_sphere_centres.begin(),
                                tool.wall_sphere_centres.end());
    request.wall_radii.resize(request.wall_centres.size(), tool.wall_sphere_radius);
  }
  return request;
}

}  // namespace

results::GrainSolidFraction measure_solid_fraction(const results::PowderState& powder,
                                                   const std::vector<results::ToolState>& tools,
                                                   const results::CavityState& cavity) {
  results::GrainSolidFraction fraction;
  if (powder.position.empty()) return fraction;
  geometry::VoronoiCells cells = geometry::voronoi_cells(voronoi_request(powder, tools));
  fraction.solid_fraction.reserve(cells.volume.size());
  for (std::size_t k = 0; k < cells.volume.size(); ++k) {
    const bool empty = !(cells.volume[k] > 0);
    fraction.solid_fraction.push_back(empty ? 0 : powder.solid_volume_of(k) / cells.volume[k]);
    fraction.open.push_back(empty || cells.open[k] != 0);
  }
  fraction.in_cavity = grains_in_cavity(cavity, powder);
  fraction.cell_volume = std::move(cells.volume);
  return fraction;
}

}  // namespace diefill::process
