#include "app/commands/bench/bench_trace.h"

#include <cstdio>
#include <string>

#include "engine/observe/energy_balance.h"
#include "engine/simulation/simulation.h"
#include "process/results/formatted.h"
#include "process/results/storage/atomic_file.h"

namespace diefill::app {

namespace {

std::string energy_row(const engine::Simulation& simulation) {
  const auto energy = engine::energy_of(simulation);
  return results::formatted("%.9g,%.9g,%.9g\n", simulation.time(), energy.translation, energy.rotation);
}

std::string grain_rows(const engine::Simulation& simulation) {
  std::string rows = "id,x,y,z,vx,vy,vz,wx,wy,wz\n";
  const auto& grains = simulation.grains();
  for (std::size_t k = 0; k < grains.size(); ++k) {
    const Eigen::Vector3d &place = grains.position[k], &velocity = grains.velocity[k];
    const Eigen::Vector3d spin = simulation.angular_velocity(k);
    char row[320];
    std::snprintf(row, sizeof row, "%llu,%.12g,%.12g,%.12g,%.12g,%.12g,%.12g,%.12g,%.12g,%.12g\n",
                  static_cast<unsigned long long>(grains.id[k]), place[0], place[1], place[2], velocity[0],
                  velocity[1], velocity[2], spin[0], spin[1], spin[2]);
    rows += row;
  }
  return rows;
}

}  // namespace

void trace(engine::Simulation& simulation, int steps, int every, const std::filesystem::path& folder) {
  std::error_code failure;
  std::filesystem::create_directories(folder, failure);  // writing says what is wrong where it fails
  std::string energies = "time_s,translation_J,rotation_J\n" + energy_row(simulation);
  for (int step = 1; step <= steps; ++step) {
    simulation.step();
    if (step % every == 0) energies += energy_row(simulation);
  }
  results::write_text_atomically(folder / "energy.csv", energies);
  results::write_text_atomically(folder / "grains.csv", grain_rows(simulation));
}

}  // namespace diefill::app
