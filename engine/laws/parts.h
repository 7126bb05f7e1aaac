// What the parts of a contact law look like. A law is one normal part, one damping, one friction, one rolling
// resistance and one distant attraction; each is built from a small `Parameters` struct of its own and the
// PairProperties, and is made of plain doubles and Vector3, so that loops over many contacts vectorise.
//
// Signs: the normal n points from j to i, a positive normal force repels, the overlap h is positive in
// contact and the separation speed (v_i - v_j) . n positive when separating. `memory` points to the part's
// kMemory doubles of the pair; they are zero when a contact begins.
//
// Each `Parameters` also knows
//   check()      throws std::invalid_argument when a value makes no sense;
//   similar(l)   the parameters that give l^2 times the force at l times the lengths and the same speeds:
//   what
//                coarse graining by parameters needs (Bierwisch 2009, Eq. 3.7; Hu 2024, section 3.4).
#pragma once

#include <concepts>

#include "engine/laws/pair_properties.h"
#include "engine/vector3.h"

namespace diefill::engine::laws {

/// Normal force that does not depend on speed.
struct StaticForce {
  double force = 0;  ///< N, positive repels
  double limit = 0;  ///< N, what friction and rolling limits are taken of, damping left out
};

template <class T>
concept Part = requires(const typename T::Parameters& parameters, const PairProperties& pair, double scale) {
  T(parameters, pair);
  parameters.check();
  { parameters.similar(scale) } -> std::same_as<typename T::Parameters>;
};

/// force(h, sqrt(h), memory) in N; energy(h, memory): J that can be had back, zero at h = 0;
/// stiffness(h, memory): N/m, the steepest slope to resolve in time.
template <class T>
concept NormalPart = Part<T> && requires(const T& part, double x, double* memory, const double* past) {
  { T::kMemory } -> std::convertible_to<int>;
  { part.force(x, x, memory) } -> std::same_as<StaticForce>;
  { part.energy(x, past) } -> std::same_as<double>;
  { part.stiffness(x, past) } -> std::same_as<double>;
};

/// force(h, sqrt(h), separation speed) in N.
template <class T>
concept DampingPart = Part<T> && requires(const T& part, double x) {
  { part.force(x, x, x) } -> std::same_as<double>;
};

/// force(memory, n, sliding velocity in m/s, sqrt(h), load in N, time step in s): tangential force on i in N.
/// Advances the memory over the time step.
template <class T>
concept FrictionPart = Part<T> && requires(const T& part, double* memory, Vector3 v, double x) {
  { T::kMemory } -> std::convertible_to<int>;
  { part.force(memory, v, v, x, x, x) } -> std::same_as<Vector3>;
};

/// torque(memory, n, omega_i - omega_j in rad/s, sqrt(h), static force, load in N, time step in s): couple on
/// i in N m; j receives the opposite. Advances the memory over the time step.
template <class T>
concept RollingPart = Part<T> && requires(const T& part, double* memory, Vector3 v, double x, StaticForce f) {
  { T::kMemory } -> std::convertible_to<int>;
  { part.torque(memory, v, v, x, f, x, x) } -> std::same_as<Vector3>;
};

/// range(): m, the largest gap at which it acts; force(gap, memory): N, negative (attraction), gap < 0 in
/// contact; energy(gap, memory): J, zero beyond the range.
template <class T>
concept AttractionPart = Part<T> && requires(const T& part, double x, double* memory, const double* past) {
  { T::kMemory } -> std::convertible_to<int>;
  { part.range() } -> std::same_as<double>;
  { part.force(x, memory) } -> std::same_as<double>;
  { part.energy(x, past) } -> std::same_as<double>;
};

}  // namespace diefill::engine::laws
