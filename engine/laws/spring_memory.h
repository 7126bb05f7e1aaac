// Vectors kept in a contact's memory, and their turning with the contact plane.
#pragma once

#include "engine/laws/parts.h"
#include "engine/vector3.h"

namespace diefill::engine::laws {

/// kMemorySigns of a vector: it points the other way for the other sphere.
inline constexpr MemorySigns<3> kVectorSigns = {-1, -1, -1};

inline Vector3 load_vector(const double* memory) {
  return {memory[0], memory[1], memory[2]};
}
inline void store_vector(double* memory, Vector3 v) {
  memory[0] = v.x;
  memory[1] = v.y;
  memory[2] = v.z;
}
/// v without its part along the unit vector n.
inline Vector3 in_plane(Vector3 v, Vector3 n) {
  return v - dot(v, n) * n;
}
/// What shortens a vector of `length` to `limit`; 1 if it is no longer than that.
inline double shortening(double length, double limit) {
  return length > limit ? limit / length : 1.0;
}

}  // namespace diefill::engine::laws
