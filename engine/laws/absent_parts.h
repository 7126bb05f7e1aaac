// The parts that do nothing: a law without damping, friction, rolling resistance or distant attraction.
#pragma once

#include "engine/laws/parts.h"

namespace diefill::engine::laws {

/// Parameters of a part that does nothing; `Tag` keeps the kinds apart.
template <class Tag>
struct NoParameters {
  void check() const {}
  NoParameters similar(double) const { return {}; }
  bool dissipates() const { return false; }
  bool attracts() const { return false; }
  bool surface_forces() const { return false; }
  double largest_friction() const { return 0; }
  bool set_friction(double friction) const { return friction == 0; }
  double own_spin_arm() const { return 0; }
  void set_time_step(double) {}
};

struct NoDamping {
  using Parameters = NoParameters<NoDamping>;
  NoDamping(const Parameters&, const PairProperties&) {}
  double force(double, double, double) const { return 0; }
  double damping(double, double) const { return 0; }
};

/// Surfaces without friction.
struct FreeSliding {
  using Parameters = NoParameters<FreeSliding>;
  static constexpr int kHistory = 0;
  static constexpr HistorySigns<0> kHistorySigns = {};
  FreeSliding(const Parameters&, const PairProperties&) {}
  Vector3 force(double*, Vector3, Vector3, double, double, double) const { return {}; }
};

/// Grains that roll without resistance.
struct FreeRolling {
  using Parameters = NoParameters<FreeRolling>;
  static constexpr int kHistory = 0;
  static constexpr HistorySigns<0> kHistorySigns = {};
  static constexpr bool follows_time_step() { return false; }
  FreeRolling(const Parameters&, const PairProperties&) {}
  Vector3 torque(double*, Vector3, Vector3, double, StaticForce, double, double) const { return {}; }
};

struct NoAttraction {
  using Parameters = NoParameters<NoAttraction>;
  static constexpr int kHistory = 0;
  static constexpr HistorySigns<0> kHistorySigns = {};
  NoAttraction(const Parameters&, const PairProperties&) {}
  double range() const { return 0; }
  double force(double, double*) const { return 0; }
  double energy(double, const double*) const { return 0; }
};

static_assert(DampingPart<NoDamping> && FrictionPart<FreeSliding> && RollingPart<FreeRolling> &&
              AttractionPart<NoAttraction>);

}  // namespace diefill::engine::laws
