// Repairs what can be repaired in a mesh without guessing, and lists what it did.
#pragma once

#include <string>
#include <vector>

#include "geometry/mesh/mesh.h"
#include "geometry/mesh/mesh_check.h"

namespace diefill::geometry {

/// How far a repair may go.
enum class RepairLevel {
  kOff,   ///< nothing is touched
  kSafe,  ///< weld, orient, fill small holes, drop duplicates and slivers, unite shells that overlap
  kWrap   ///< where that is not enough: a new surface wrapped round the old one, which rounds off what is
          ///< sharp
};

/// Limits of a repair. Lengths in m.
struct RepairOptions {
  RepairLevel level = RepairLevel::kSafe;
  /// Loose corners closer than this part of the bounding box's diagonal are welded.
  double weld = 1e-5;
  /// A hole is filled when the patch is at most this part of the surface: a larger one may be an opening.
  /// Holes that touch at a corner count one by one.
  double largest_hole = 0.01;
  /// Size of the features that a wrap still follows; 0: a hundredth of the bounding box's diagonal.
  double wrap_detail = 0;
};

/// A mesh after repair and what was done to it.
struct RepairedMesh {
  Mesh mesh;
  MeshFindings findings;             ///< of `mesh`, as it is now
  std::vector<std::string> repairs;  ///< what was done, one per line; empty when nothing was
  std::vector<std::string> refused;  ///< what could be done, but not without guessing, and why it was not
  /// m, largest distance between a point of either surface and the other one; 0 unless wrapped.
  double largest_deviation = 0;
};

/// Repairs `mesh`, whose check gave `findings`. A mesh that is usable and has no duplicates comes back
/// untouched. Deterministic. Never throws for a bad mesh: what cannot be repaired stays in the findings.
RepairedMesh repair_mesh(const Mesh& mesh, const MeshFindings& findings, const RepairOptions& options);

}  // namespace diefill::geometry
