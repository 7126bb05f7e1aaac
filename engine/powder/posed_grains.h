// A few clumped grains where they are, one lane each, and the places of their spheres.
#pragma once

#include "engine/powder/quaternion_lanes.h"

namespace diefill::engine {

struct PosedGrains {
  static constexpr std::size_t kGrains = 16;
  using Vectors = VectorLanes<kGrains>;

  Vectors centre;                        ///< m, of mass
  QuaternionLanes<kGrains> orientation;  ///< body to laboratory
  Vectors row_x, row_y, row_z;           ///< of the rotations, once turned
  Vectors place;                         ///< m, of one sphere of each grain, laboratory frame, once placed

  /// The rotations of the first `lanes` grains, which are whole groups.
  void turn(std::size_t lanes) {
#pragma GCC ivdep
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      const Rotation rotation = rotation_of(orientation[lane]);
      row_x.set(lane, rotation.row_x);
      row_y.set(lane, rotation.row_y);
      row_z.set(lane, rotation.row_z);
    }
  }
  Rotation rotation(std::size_t lane) const {
    return {row_x[lane], row_y[lane], row_z[lane]};
  }
  /// The places of the spheres at `offset` (m, body frame), the same in all lanes.
  void place_spheres(std::size_t lanes, Vector3 offset) {
    place_spheres_at(lanes, [offset](std::size_t) { return offset; });
  }
  /// The same with an offset for each.
  void place_spheres(std::size_t lanes, const Vectors& offset) {
    place_spheres_at(lanes, [&offset](std::size_t lane) { return offset[lane]; });
  }

 private:
  template <class OffsetOf>
  void place_spheres_at(std::size_t lanes, const OffsetOf& offset) {
#pragma GCC ivdep
    for (std::size_t lane = 0; lane < lanes; ++lane)
      place.set(lane, centre[lane] + rotation(lane) * offset(lane));
  }
};

}  // namespace diefill::engine
