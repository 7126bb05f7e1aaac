#include "process/laboratory/published/sawing/groove.h"

#include <algorithm>

#include "process/laboratory/published/sawing/fluid_bytes.h"
#include "process/laboratory/published/sawing/groove_film.h"
#include "process/laboratory/published/sawing/groove_measures.h"
#include "process/laboratory/published/sawing/sawing_json.h"

namespace diefill::process::laboratory::sawing {
namespace {

constexpr int kReportInterval = 20;  // steps

engine::FluidSettings settings_of(const GrooveCase& one, std::uint64_t seed) {
  engine::FluidSettings settings;
  settings.period = {std::nullopt, one.length, std::nullopt};
  settings.law.grip = one.grip;
  settings.seed = seed;
  return settings;
}

SlurryMixture mixture_of(const GrooveCase& one) {
  return {.solids = one.solids};
}

template <class Io, class Sums>
void transfer_sums(Io& io, Sums& sums) {
  io(sums.figures.stress);
  io(sums.figures.grains);
  io(sums.figures.time);
  io(sums.figures.distance);
  io(sums.figures.mean_distance);
  io(sums.figures.temperature);
  io(sums.figures.particle_steps);
  io(sums.samples);
  io(sums.lid_force);
  io(sums.speed);
  io(sums.count);
  io(sums.grain_pressure);
}

/// One run, and what it has found so far.
class Sawing {
 public:
  Sawing(const GrooveCase& one, std::uint64_t seed)
      : case_(one), seed_(seed), simulation_(settings_of(one, seed)) {
    parts_.wire = simulation_.add_solid(wire_of(one));
    parts_.first_of_ingot = simulation_.state().next_id;
    parts_.ingot = simulation_.add_solid(ingot_of(one, parts_.surface));
    parts_.lid = simulation_.add_solid(lid_of(one));
    parts_.slurry = fill(space_of(one), mixture_of(one), seed, simulation_);
  }

  GrooveFigures run(CustomRunWatch& watch) {
    if (!watch.begun().empty()) restore(watch.begun());
    GrooveMeasures measures(case_, parts_, sums_);
    const int all = case_.settling + case_.sampled;
    for (int k = static_cast<int>(simulation_.state().step) + 1; k <= all; ++k) {
      simulation_.step();
      measures.note_distance(simulation_);
      if (k > case_.settling) measures.sample(simulation_, k - case_.settling);
      if (case_.instants > 0 && k % std::max(1, all / case_.instants) == 0)
        instants_.push_back(instant_of(simulation_, parts_));
      if (k % kReportInterval == 0) watch.report(static_cast<double>(k) / all, [&] { return state(); });
    }
    measures.conclude(simulation_);
    if (case_.instants > 0) write_film(watch.folder(), {case_, parts_, simulation_, seed_}, instants_);
    return sums_.figures;
  }

 private:
  std::string state() const {
    ByteWriter writer;
    const engine::FluidSnapshot fluid = simulation_.snapshot();
    transfer_fluid(writer, fluid);
    transfer_sums(writer, sums_);
    transfer_instants(writer, instants_);
    return writer.bytes();
  }

  void restore(const std::string& bytes) {
    ByteReader reader(bytes);
    engine::FluidSnapshot fluid;
    transfer_fluid(reader, fluid);
    transfer_sums(reader, sums_);
    transfer_instants(reader, instants_);
    simulation_.restore(fluid);
  }

  GrooveCase case_;
  std::uint64_t seed_;
  engine::FluidSimulation simulation_;
  GrooveParts parts_;
  GrooveSums sums_;
  std::vector<results::Instant> instants_;
};

}  // namespace

std::string settings_text(const GrooveCase& one) {
  const engine::FluidSettings fluid = settings_of(one, 0);
  nlohmann::ordered_json json = fluid_settings(fluid);
  json.update({{"wire_radius", one.wire_radius},
               {"groove_radius", one.groove_radius},
               {"top", one.top},
               {"length", one.length},
               {"wire_start", one.wire_start},
               {"speed", one.speed},
               {"pressure", one.pressure},
               {"solids", one.solids},
               {"sizes", mixture_of(one).sizes},
               {"settling", one.settling},
               {"sampled", one.sampled},
               {"instants", one.instants}});
  return json.dump();
}

double work_of(const GrooveCase& one) {
  constexpr double kWalls = 2 / kSpacing / kSpacing;  // particles, of a unit of surface
  const SlurrySpace space = space_of(one);
  const double surface =
      (2 * one.wire_radius + one.groove_radius) * 3.1416 + 2 * (one.top + one.groove_radius);
  const double slurry =
      one.solids / (kSpacing * kSpacing * kSpacing) + (1 - one.solids) * mixture_of(one).density;
  return (space.volume * slurry + kWalls * surface * one.length) * (one.settling + one.sampled);
}

GrooveFigures saw(const GrooveCase& one, std::uint64_t seed, CustomRunWatch& watch) {
  return Sawing(one, seed).run(watch);
}

}  // namespace diefill::process::laboratory::sawing
