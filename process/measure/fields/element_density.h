// The density of the filled powder in the elements of a finite-element mesh, for the simulation of pressing.
#pragma once

#include <vector>

#include "process/results/fill_result.h"
#include "process/results/solid_mesh.h"

namespace diefill::process {

/// What the mesh has to hold.
struct DensityRequest {
  double averaging_width = 0;  ///< m, sigma of (Bierwisch 2009, Eq. 2.27)
  double mass = 0;             ///< kg, of the whole mesh
  double solid_density = 0;    ///< kg/m^3, of the solid that this mass consists of; 0: of the grains'
};

/// Density is that of the powder over the element's volume; relative density is density over `solid_density`.
struct ElementDensity {
  std::vector<double> volume;          ///< m^3, of each element
  std::vector<double> mass;            ///< kg, of each element; 0 outside the powder
  std::vector<double> relative;        ///< 1, of each element; 0 outside the powder
  std::vector<double> filled;          ///< 1, share of each element that lies in the powder
  std::vector<double> node_volume;     ///< m^3: each element's volume in equal parts to its nodes
  std::vector<double> node_relative;   ///< 1, of each node; 0 where all its elements are outside
  std::vector<std::uint64_t> outside;  ///< numbers of the elements that hold no powder
  std::vector<std::uint64_t> above;    ///< numbers of the elements that are denser than their solid
  double solid_density = 0;            ///< kg/m^3, of the request
  double total_volume = 0;             ///< m^3, of the mesh
  double scale = 1;                    ///< by which the averaged field was multiplied to conserve mass
};

/// kg/m^3 of the grains' solid: mass over solid volume of all grains in the cavity (of all where none is).
double solid_density(const results::FillResult& result);

/// Averages the field of solid fractions (GaussianField) over each element, in points at most sigma apart and
/// at least 16 an element; points outside the powder count as 0. Then multiplies all elements by one factor,
/// so that their masses sum to the request's. Nodes: the volume-weighted mean of their elements, which with
/// `node_volume` has the same mass. Throws std::invalid_argument where no element lies in the powder, and
/// geometry::MeshError where the mesh would hold more than its volume of solid, or more than a tenth of the
/// mass would lie in elements denser than the solid.
ElementDensity element_density(const results::FillResult& result, const results::SolidMesh& mesh,
                               const DensityRequest& request);

}  // namespace diefill::process
