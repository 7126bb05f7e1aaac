// Speed of a fluid of particles under shear, and its viscosity: bin/fluid_speed EDGE RATE SOLIDS STEPS.
#include <chrono>
#include <cstdio>
#include <cstdlib>

#include "process/laboratory/published/sawing/viscosity.h"

int main(int count, char** arguments) {
  using namespace diefill::process::laboratory::sawing;
  if (count != 5) {
    std::fputs("usage: fluid_speed EDGE RATE SOLIDS STEPS (reduced units; solids: share of the volume)\n",
               stderr);
    return 2;
  }
  ShearedSlurry slurry;
  slurry.edge = std::atof(arguments[1]);
  slurry.rate = std::atof(arguments[2]);
  slurry.solids = std::atof(arguments[3]);
  slurry.settling = std::atoi(arguments[4]) / 4;
  slurry.sampled = std::atoi(arguments[4]);
  const auto began = std::chrono::steady_clock::now();
  const ShearedFigures figures = measure(slurry, 1);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  const double steps = slurry.settling + slurry.sampled;
  std::printf(
      "particles %.0f, us a particle and step %.3f, viscosity %.3f +- %.3f, temperature %.4f, pressure %.3f, "
      "solids %.3f\n",
      figures.particles, 1e6 * seconds / (figures.particles * steps), figures.viscosity, figures.scatter,
      figures.temperature, figures.pressure, figures.solids);
  return 0;
}
