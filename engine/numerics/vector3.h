// Three doubles with the algebra of vectors. The pair loop handles many contacts at a time:
// compilers vectorise loops over plain structs, but not over Eigen's expressions.
// State and interfaces use Eigen.
#pragma once

#include <Eigen/Core>
#include <cmath>

namespace diefill::engine {

/// A vector in space; the unit is the caller's.
struct Vector3 {
  double x = 0, y = 0, z = 0;

  Vector3& operator+=(Vector3 b) { return *this = {x + b.x, y + b.y, z + b.z}; }
  Vector3& operator-=(Vector3 b) { return *this = {x - b.x, y - b.y, z - b.z}; }
};

inline Vector3 operator+(Vector3 a, Vector3 b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Vector3 operator-(Vector3 a, Vector3 b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Vector3 operator-(Vector3 a) {
  return {-a.x, -a.y, -a.z};
}
inline Vector3 operator*(double s, Vector3 a) {
  return {s * a.x, s * a.y, s * a.z};
}
inline double dot(Vector3 a, Vector3 b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline double length(Vector3 a) {
  return std::sqrt(dot(a, a));
}
inline Vector3 cross(Vector3 a, Vector3 b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

inline Vector3 plain(const Eigen::Vector3d& v) {
  return {v[0], v[1], v[2]};
}
inline Eigen::Vector3d eigen(Vector3 v) {
  return {v.x, v.y, v.z};
}

}  // namespace diefill::engine
