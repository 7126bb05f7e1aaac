#include "engine/limits/mix_time_step.h"

#include <algorithm>
#include <limits>

#include "engine/contact/pair_laws.h"
#include "engine/limits/law_probe.h"
#include "engine/limits/time_step.h"

namespace diefill::engine {

namespace {

constexpr double kNoLimit = std::numeric_limits<double>::infinity();

/// m, at which the law has taken up `energy` (J): bisection between 0 and where it holds more.
double overlap_of_energy(const laws::GeneralContactLaw& law, double energy, double radius) {
  double low = 0, high = 1e-3 * radius;
  for (int k = 0; k < 60 && law.fresh_energy(high) < energy; ++k) high *= 2;
  for (int k = 0; k < 100; ++k) {
    const double middle = 0.5 * (low + high);
    (law.fresh_energy(middle) < energy ? low : high) = middle;
  }
  return high;
}

/// Two grains of a mix that meet, or a grain and a wall.
class MeetingPair {
 public:
  MeetingPair(const KindTable& kinds, const GrainMix& mix, KindNumber i, KindNumber j)
      : law_(law_of_kinds(kinds, mix, i, j)),
        probe_(laws::law_between(mix.laws, kinds.material(i), kinds.material(j)), mix.scaling,
               {kinds.shape(i).sphere_radius, kinds.shape(j).sphere_radius, kinds.shape(i).mass,
                kinds.shape(j).mass}),
        radius_(std::min(kinds.shape(i).sphere_radius, kinds.shape(j).sphere_radius)),
        mass_(laws::PairProperties::reduced(kinds.shape(i).mass, kinds.shape(j).mass)),
        meeting_(reduced(masses_of(kinds.shape(i)), masses_of(kinds.shape(j)))),
        packed_(half_of_smaller(masses_of(kinds.shape(i)), masses_of(kinds.shape(j)))) {}
  MeetingPair(const KindTable& kinds, const GrainMix& mix, KindNumber i, const MixWall& wall)
      : law_(law_with_wall(kinds, mix, i, wall.material, wall.sphere_radius)),
        probe_(laws::law_between(mix.laws, kinds.material(i), wall.material), mix.scaling,
               {kinds.shape(i).sphere_radius, wall.sphere_radius, kinds.shape(i).mass, kNoLimit}),
        radius_(kinds.shape(i).sphere_radius),
        mass_(kinds.shape(i).mass),
        meeting_(masses_of(kinds.shape(i))),
        packed_(meeting_) {}

  /// m, of the smaller sphere.
  double radius() const { return radius_; }

  /// s, at `overlap` (m), of one contact, and of kContactsPerGrain at a tenth of the overlap on the smaller
  /// grain, whose springs count alone, as in time_step.h.
  double shortest_at(double overlap) const {
    ContactSprings packed = probe_.springs(0.1 * overlap);
    packed.damping = packed.sliding_damping = 0;
    return std::min(step_limit(probe_.springs(overlap), meeting_, 1),
                    step_limit(packed, packed_, kContactsPerGrain));
  }
  /// s, the same at an impact at `speed` (m/s).
  double shortest(double speed) const {
    const double energy = 0.5 * mass_ * speed * speed + probe_.energy_of_approach();
    return std::min(shortest_at(overlap_of_energy(law_, energy, radius_)), crossing_time(probe_, mass_));
  }

 private:
  laws::GeneralContactLaw law_;
  LawProbe probe_;
  double radius_, mass_;
  ContactMasses meeting_, packed_;
};

/// The kinds with moments of inertia as torques balance with.
KindTable moving_kinds(const GrainMix& mix) {
  auto moving = mix.kinds;
  for (auto& kind : moving) kind.shape.inertia /= mix.scaling.torque_factor();
  return KindTable(std::move(moving));
}

}  // namespace

double critical_time_step(const GrainMix& mix, const std::vector<MixWall>& walls, double impact_speed) {
  const KindTable kinds = moving_kinds(mix);
  const auto count = static_cast<KindNumber>(kinds.size());
  double critical = kNoLimit;
  for (KindNumber i = 0; i < count; ++i) {
    for (KindNumber j = i; j < count; ++j)
      critical = std::min(critical, MeetingPair(kinds, mix, i, j).shortest(impact_speed));
    for (const auto& wall : walls)
      critical = std::min(critical, MeetingPair(kinds, mix, i, wall).shortest(impact_speed));
  }
  return critical;
}

double critical_time_step_at_overlap(const GrainMix& mix, double overlap, double overlap_over_radius) {
  const KindTable kinds = moving_kinds(mix);
  const auto count = static_cast<KindNumber>(kinds.size());
  double critical = kNoLimit;
  for (KindNumber i = 0; i < count; ++i)
    for (KindNumber j = i; j < count; ++j) {
      const MeetingPair pair(kinds, mix, i, j);
      critical = std::min(critical, pair.shortest_at(std::min(overlap, overlap_over_radius * pair.radius())));
    }
  return critical;
}

}  // namespace diefill::engine
