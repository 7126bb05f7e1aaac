// Which discharge law stands for a powder.
#pragma once

#include <filesystem>
#include <string>

#include "process/continuum/discharge.h"
#include "process/scene/scene.h"

namespace diefill::process::estimate {

/// A law of discharge with what it was fitted to.
struct PowderDischarge {
  continuum::TransientCoefficients numbers;
  double longest = 0;         ///< t sqrt(g/D) - 1/5 up to which it was measured; the rate is constant beyond
  double grain_diameter = 0;  ///< m, of the grains it was measured with: others change the effective opening
  std::string source;         ///< of the numbers
  std::string applies;        ///< how well they fit this powder, as text
};

/// The law for a preset or a powder of one's own.
PowderDischarge discharge_of(const PowderSpec& powder);

/// The law that `diefill fit-discharge` wrote to `file` (fit.json). Throws SceneError where it is none.
PowderDischarge read_discharge(const std::filesystem::path& file);

/// f_B(x) with the rate kept beyond `longest`; 0 for x < 0, when nothing has run out yet.
double discharged_share(const PowderDischarge& law, double x);

}  // namespace diefill::process::estimate
