// The parts that do nothing: a law without damping, friction, rolling resistance or distant attraction.
#pragma once

#include "engine/laws/parts.h"

namespace diefill::engine::laws {

/// Parameters of a part that does nothing; `Tag` keeps the kinds apart.
template <class Tag>
struct NoParameters {
  void check() const {}
  NoParameters similar(double) const { return {}; }
};

struct NoDamping {
  using Parameters = NoParameters<NoDamping>;
  NoDamping(const Parameters&, const PairProperties&) {}
  double force(double, double, double) const { return 0; }
};

/// Surfaces without friction.
struct FreeSliding {
  using Parameters = NoParameters<FreeSliding>;
  static constexpr int kMemory = 0;
  FreeSliding(const Parameters&, const PairProperties&) {}
  Vector3 force(double*, Vector3, Vector3, double, double, double) const { return {}; }
};

/// Grains that roll without resistance.
struct FreeRolling {
  using Parameters = NoParameters<FreeRolling>;
  static constexpr int kMemory = 0;
  FreeRolling(const Parameters&, const PairProperties&) {}
  Vector3 torque(double*, Vector3, Vector3, double, StaticForce, double, double) const { return {}; }
};

struct NoAttraction {
  using Parameters = NoParameters<NoAttraction>;
  static constexpr int kMemory = 0;
  NoAttraction(const Parameters&, const PairProperties&) {}
  double range() const { return 0; }
  double force(double, double*) const { return 0; }
  double energy(double, const double*) const { return 0; }
};

static_assert(DampingPart<NoDamping> && FrictionPart<FreeSliding> && RollingPart<FreeRolling> &&
              AttractionPart<NoAttraction>);

}  // namespace diefill::engine::laws
