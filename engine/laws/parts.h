// The interface of the parts of a contact law. A law is one normal part, one damping, one friction, one
// rolling resistance and one distant attraction. Each is built from its own small `Parameters` and the
// PairProperties, and consists of plain doubles and Vector3, so that loops over many contacts vectorise.
//
// Signs: the normal n points from j to i, a positive normal force repels, the overlap h is positive in
// contact and the separation speed (v_i - v_j) . n positive when separating. `history` points to the part's
// kHistory doubles of the pair; they are zero when a contact begins. `kHistorySigns` has one factor for each:
// -1 where the number turns its sign when the pair is stored the other way round, i and j exchanged, as parts
// of vectors do, otherwise 1. A part whose parameters decide in which unit it stores them has a
// history_unit(), a small number for each unit.
//
// Each `Parameters` also knows
//   check()      throws std::invalid_argument when a value makes no sense;
//   similar(l)   the parameters that give l^2 times the force at l times the lengths and the same speeds:
//                what coarse graining by parameters needs (Bierwisch 2009, Eq. 3.7; Hu 2024, section 3.4).
// and the facts of its kind that others ask for: a part's formula and what follows from it stand in its file
// alone.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>

#include "engine/laws/pair_properties.h"
#include "engine/numerics/vector3.h"

namespace diefill::engine::laws {

/// Normal force that does not depend on speed.
struct StaticForce {
  double force = 0;  ///< N, positive repels
  double limit = 0;  ///< N, what friction and rolling limits are taken of, damping left out
};

/// kHistorySigns of a part that stores `kCount` numbers.
template <std::size_t kCount>
using HistorySigns = std::array<double, kCount>;

template <class T>
concept HasHistory = requires {
  { T::kHistory } -> std::convertible_to<int>;
  requires T::kHistorySigns.size() == static_cast<std::size_t>(T::kHistory);
};

template <class T>
concept Part = requires(const typename T::Parameters& parameters, const PairProperties& pair, double scale) {
  T(parameters, pair);
  parameters.check();
  { parameters.similar(scale) } -> std::same_as<typename T::Parameters>;
};

/// force(h, sqrt(h), history) in N; energy(h, history): J that can be had back, zero at h = 0;
/// stiffness(h, history): N/m, the steepest slope to resolve in time.
///   hysteretic()             whether the force depends on earlier overlaps, so that cycles take out energy
/// and of its parameters
///   damping_in_load()        whether the load of friction limits has damping in it, unless a scene says
///                            otherwise
///   attracts()               whether touching spheres stick
///   includes_surface_forces() whether its adhesion is the surface forces that an attraction may have, too
///   hertzian_modulus()       Pa, E* of a first loading 4/3 E* sqrt(R*) h^(3/2), or 0
///   linear_stiffness()       N/m, k_1 of a first loading k_1 h, or 0
///   set_work_of_adhesion(w)  J/m^2, of another surface; false where the law has none
template <class T>
concept NormalPart = Part<T> && HasHistory<T> &&
    requires(const T& part, double x, double* history, const double* past,
             const typename T::Parameters& given, typename T::Parameters& changed) {
  { part.hysteretic() } -> std::same_as<bool>;
  { given.damping_in_load() } -> std::same_as<bool>;
  { given.attracts() } -> std::same_as<bool>;
  { given.includes_surface_forces() } -> std::same_as<bool>;
  { given.hertzian_modulus() } -> std::same_as<double>;
  { given.linear_stiffness() } -> std::same_as<double>;
  { changed.set_work_of_adhesion(x) } -> std::same_as<bool>;
  { part.force(x, x, history) } -> std::same_as<StaticForce>;
  { part.energy(x, past) } -> std::same_as<double>;
  { part.stiffness(x, past) } -> std::same_as<double>;
};

/// force(h, sqrt(h), separation speed) in N; damping(h, sqrt(h)): kg/s, what the speed is multiplied by.
/// dissipates(): whether it takes out any energy.
template <class T>
concept DampingPart = Part<T> && requires(const T& part, double x, const typename T::Parameters& given) {
  { given.dissipates() } -> std::same_as<bool>;
  { part.damping(x, x) } -> std::same_as<double>;
  { part.force(x, x, x) } -> std::same_as<double>;
};

/// force(history, n, sliding velocity in m/s, sqrt(h), load in N, time step in s): tangential force on i in
/// N. Advances the history over the time step. largest_friction(): Coulomb's coefficient, the larger one
/// where there are two. set_friction(mu): that of another surface; false where the law has none.
template <class T>
concept FrictionPart = Part<T> && HasHistory<T> &&
    requires(const T& part, double* history, Vector3 v, double x, const typename T::Parameters& given,
             typename T::Parameters& changed) {
  { given.largest_friction() } -> std::same_as<double>;
  { changed.set_friction(x) } -> std::same_as<bool>;
  { part.force(history, v, v, x, x, x) } -> std::same_as<Vector3>;
};

/// torque(history, n, omega_i - omega_j in rad/s, sqrt(h), static force, load in N, time step in s): torque
/// on i in N m; j receives the opposite. Advances the history over the time step. follows_time_step():
/// whether its spring is made for the time step, and so needs none. set_time_step(s) gives its
/// parameters the time step of the original grains. own_spin_arm(): m, what the load is multiplied by for a
/// torque against each grain's own spin, which the integrator applies; 0 where the part acts on the pair.
template <class T>
concept RollingPart = Part<T> && HasHistory<T> &&
    requires(const T& part, double* history, Vector3 v, double x, StaticForce f,
             typename T::Parameters& given) {
  given.set_time_step(x);
  { given.own_spin_arm() } -> std::same_as<double>;
  { part.follows_time_step() } -> std::same_as<bool>;
  { part.torque(history, v, v, x, f, x, x) } -> std::same_as<Vector3>;
};

/// range(): m, the largest gap at which it acts; force(gap, history): N, negative (attraction), gap < 0 in
/// contact; energy(gap, history): J, zero beyond the range. attracts(): whether there is any force;
/// surface_forces(): whether it is the forces between dry surfaces.
template <class T>
concept AttractionPart = Part<T> && HasHistory<T> &&
    requires(const T& part, double x, double* history, const double* past,
             const typename T::Parameters& given) {
  { given.surface_forces() } -> std::same_as<bool>;
  { given.attracts() } -> std::same_as<bool>;
  { part.range() } -> std::same_as<double>;
  { part.force(x, history) } -> std::same_as<double>;
  { part.energy(x, past) } -> std::same_as<double>;
};

}  // namespace diefill::engine::laws
