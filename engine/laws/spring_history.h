// Vectors in a contact's history, and how they turn with the contact plane.
#pragma once

#include "engine/laws/parts.h"
#include "engine/numerics/vector3.h"

namespace diefill::engine::laws {

/// kHistorySigns of a vector: it points the other way for the other sphere.
inline constexpr HistorySigns<3> kVectorSigns = {-1, -1, -1};

inline Vector3 load_vector(const double* history) {
  return {history[0], history[1], history[2]};
}
inline void store_vector(double* history, Vector3 v) {
  history[0] = v.x;
  history[1] = v.y;
  history[2] = v.z;
}
/// v without its part along the unit vector n.
inline Vector3 in_plane(Vector3 v, Vector3 n) {
  return v - dot(v, n) * n;
}
/// Factor that shortens a vector of `length` to `limit`; 1 if it is not longer.
inline double shortening(double length, double limit) {
  return length > limit ? limit / length : 1.0;
}

}  // namespace diefill::engine::laws
