// Speed of steps on ranks beside that of the built-in engine: mpirun -np N bin/rank_speed [GRAINS [STEPS]];
// not a test. Model D in a periodic box settles for a while; then each engine steps it on. Rates are those of
// all ranks together: by processor time of rank 0, which hides how long it waits while other programs run,
// and by the clock, which needs as many idle cores as ranks.
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>

#include "engine/observe/powder_figures.h"
#include "process/cluster/lammps/lammps_engine.h"
#include "tests/engine/engine_test_support.h"

namespace {

using namespace diefill;

constexpr int kSettling = 15000;  // steps

double processor_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Time since it was made.
class Watch {
 public:
  double processor() const { return processor_seconds() - processor_; }  ///< s, of this rank
  double clock() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - clock_).count();  ///< s
  }

 private:
  double processor_ = processor_seconds();
  std::chrono::steady_clock::time_point clock_ = std::chrono::steady_clock::now();
};

/// Grains that fall on a plane, as the presets' powders do.
engine::Simulation bed(int grains) {
  auto settings = engine::weightless(engine::Model::d, {.friction = 0.3, .work_of_adhesion = 0.005}, 2e-6);
  settings.gravity = {0, 0, -9.81};
  settings.air_viscosity = 1.8e-5;
  const double size = 2 * engine::half_size(settings.shape());
  const int edge = std::max(4, static_cast<int>(std::lround(std::cbrt(grains))));
  settings.period = {edge * size, edge * size};
  engine::WallBodySpec floor;
  floor.name = "floor";
  floor.planes = {{Eigen::Vector3d(0, 0, -0.55 * edge * size), Eigen::Vector3d::UnitZ()}};
  engine::Simulation simulation(settings, {floor});
  auto cloud = engine::converging_cloud({edge, edge, edge}, 0.97 * size, 0.05, 7);
  for (auto& grain : cloud) grain.velocity.z() -= 0.1;
  simulation.add_grains(cloud);
  return simulation;
}

void report(const char* name, const engine::Simulation& simulation, int steps, const Watch& watch) {
  const double sphere_steps = static_cast<double>(engine::sphere_count(simulation)) * steps;
  std::printf(
      "%-10s %8zu spheres, %.2f contacts each, million sphere-steps/s: %.2f by processor time, %.2f by the "
      "clock\n",
      name, engine::sphere_count(simulation),
      static_cast<double>(simulation.touching_pairs()) /
          static_cast<double>(engine::sphere_count(simulation)),
      1e-6 * sphere_steps / watch.processor(), 1e-6 * sphere_steps / watch.clock());
}

void compare(process::cluster::RankEngine& ranks, int grains, int steps) {
  process::cluster::LammpsEngine engine(ranks);
  auto simulation = bed(grains);
  engine::run_steps(simulation, kSettling);
  const Watch alone;
  engine::run_steps(simulation, steps);
  report("built-in", simulation, steps, alone);
  engine.step(simulation, simulation.steps() + 1);
  engine.sync_contacts(simulation);
  const Watch together;
  for (int k = 0; k < steps; ++k) engine.step(simulation, (simulation.steps() / 10 + 1) * 10);
  report("on ranks", simulation, steps, together);
  const auto spheres = static_cast<double>(engine::sphere_count(simulation));
  const Watch grains_shown;
  engine.sync_grains(simulation);
  std::printf("grains shown in %.3g ns a sphere, ", 1e9 * grains_shown.processor() / spheres);
  const Watch contacts_shown;
  engine.sync_contacts(simulation);
  std::printf("contacts in %.3g ns a sphere\n", 1e9 * contacts_shown.processor() / spheres);
  std::printf("%s\n", engine.description().c_str());
}

}  // namespace

int main(int argc, char** argv) {
  MPI_Init(&argc, &argv);
  {
    process::cluster::RankEngine ranks(MPI_COMM_WORLD);
    if (ranks.rank() == 0)
      compare(ranks, argc > 1 ? std::atoi(argv[1]) : 1000, argc > 2 ? std::atoi(argv[2]) : 1000);
    else
      process::cluster::serve(ranks);
  }
  MPI_Finalize();
}
