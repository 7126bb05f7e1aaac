#include "process/measure/fields/element_density.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "geometry/grids/all_cores.h"
#include "geometry/mesh/mesh.h"
#include "process/measure/fields/gaussian_field.h"
#include "process/measure/weights.h"

namespace diefill::process {
namespace {

using results::SolidElement;
using results::SolidMesh;
using results::Tetrahedron;

/// Sums over the points of one element.
struct ElementSum {
  double volume = 0, powder = 0, solid = 0;  // m^3: all, in the powder, times its solid fraction
};

double longest_edge(const Tetrahedron& corners) {
  double longest = 0;
  for (std::size_t a = 0; a < 4; ++a)
    for (std::size_t b = a + 1; b < 4; ++b) longest = std::max(longest, (corners[a] - corners[b]).norm());
  return longest;
}

/// Four points of equal weight, exact for a field of second degree (Hammer, Marlowe and Stroud 1956).
void add_points(const Tetrahedron& corners, const GaussianField& field, ElementSum& sum) {
  constexpr double kNear = 0.5854101966249685, kFar = 0.1381966011250105;
  const double part = 0.25 * results::signed_volume(corners);
  const Eigen::Vector3d all = corners[0] + corners[1] + corners[2] + corners[3];
  for (const auto& corner : corners) {
    const double fraction = field.at(kFar * all + (kNear - kFar) * corner);
    sum.volume += part;
    if (!std::isfinite(fraction)) continue;
    sum.powder += part;
    sum.solid += part * fraction;
  }
}

/// Halves the longest edge until none is longer than `spacing`, at most `halvings` times.
void add_parts(const Tetrahedron& corners, const GaussianField& field, double spacing, int halvings,
               ElementSum& sum) {
  if (halvings == 0 || longest_edge(corners) <= spacing) {
    add_points(corners, field, sum);
    return;
  }
  std::size_t one = 0, other = 1;
  for (std::size_t a = 0; a < 4; ++a)
    for (std::size_t b = a + 1; b < 4; ++b)
      if ((corners[a] - corners[b]).norm() > (corners[one] - corners[other]).norm()) one = a, other = b;
  const Eigen::Vector3d middle = 0.5 * (corners[one] + corners[other]);
  for (const std::size_t replaced : {one, other}) {
    Tetrahedron half = corners;
    half[replaced] = middle;
    add_parts(half, field, spacing, halvings - 1, sum);
  }
}

void share_among_nodes(const SolidMesh& mesh, ElementDensity& density) {
  density.node_volume.assign(mesh.nodes.size(), 0);
  density.node_relative.assign(mesh.nodes.size(), 0);
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    const int nodes = results::kind_of(mesh.elements[e].shape).nodes;
    const double part = density.volume[e] / nodes;
    for (int n = 0; n < nodes; ++n) {
      const std::uint32_t node = mesh.elements[e].nodes[static_cast<std::size_t>(n)];
      density.node_volume[node] += part;
      density.node_relative[node] += part * density.relative[e];
    }
  }
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n)
    if (density.node_volume[n] > 0) density.node_relative[n] /= density.node_volume[n];
}

/// No powder is denser than its solid.
void refuse_above_solid(const ElementDensity& density, double mass) {
  constexpr double kMaxAbove = 0.1;  // of the mass
  double above = 0, filled = 0;
  for (std::size_t e = 0; e < density.mass.size(); ++e) {
    if (density.relative[e] > 1) above += density.mass[e];
    filled += density.filled[e] * density.volume[e];
  }
  if (!(above > kMaxAbove * mass)) return;
  const double relative = mass / (density.solid_density * filled);
  std::array<char, 400> text{};
  std::snprintf(text.data(), text.size(),
                "the mesh would hold %.6g g in the %.6g mm^3 that lie in the powder, a relative density of "
                "%.4g, allowed: up to 1, the solid of %.0f kg/m^3 (%.3g %% of the mass is in elements "
                "above it); check the mass (--mass, --mesh-share), and size and position of the mesh "
                "(--mesh-unit, --mesh-position)",
                1e3 * mass, 1e9 * filled, relative, density.solid_density, 100 * above / mass);
  throw geometry::MeshError(text.data());
}

}  // namespace

double solid_density(const results::FillResult& result) {
  std::vector<std::size_t> grains;
  const auto& in_cavity = result.solid_fraction.in_cavity;
  for (std::size_t k = 0; k < in_cavity.size(); ++k)
    if (in_cavity[k] != 0) grains.push_back(k);
  if (grains.empty())
    for (std::size_t k = 0; k < result.powder.position.size(); ++k) grains.push_back(k);
  return mass(result.powder, grains) / solid_volume(result.powder, grains);
}

ElementDensity element_density(const results::FillResult& result, const SolidMesh& mesh,
                               const DensityRequest& request) {
  constexpr int kMaxHalvings = 12;
  const GaussianField field(result.powder, result.solid_fraction, request.averaging_width);
  std::vector<ElementSum> sums(mesh.elements.size());
  geometry::on_all_cores(sums.size(), [&](std::size_t e) {
    for (const auto& part : results::tetrahedra_of(mesh, mesh.elements[e]))
      add_parts(part, field, request.averaging_width, kMaxHalvings, sums[e]);
  });
  ElementDensity density;
  density.solid_density = request.solid_density > 0 ? request.solid_density : solid_density(result);
  double solid = 0;
  for (std::size_t e = 0; e < sums.size(); ++e) {
    density.volume.push_back(std::abs(sums[e].volume));
    density.filled.push_back(sums[e].powder / sums[e].volume);
    density.relative.push_back(sums[e].solid / sums[e].volume);
    if (!(density.relative[e] > 0)) density.outside.push_back(mesh.elements[e].number);
    solid += std::abs(sums[e].solid);
    density.total_volume += density.volume[e];
  }
  if (!(solid > 0)) throw std::invalid_argument("no element lies in the powder");
  density.scale = request.mass / (density.solid_density * solid);
  for (std::size_t e = 0; e < sums.size(); ++e) {
    density.relative[e] *= density.scale;
    density.mass.push_back(density.solid_density * density.relative[e] * density.volume[e]);
    if (density.relative[e] > 1) density.above.push_back(mesh.elements[e].number);
  }
  refuse_above_solid(density, request.mass);
  share_among_nodes(mesh, density);
  return density;
}

}  // namespace diefill::process
