// Which discharge law stands for a powder.
#pragma once

#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "process/continuum/discharge.h"
#include "process/scene/scene.h"

namespace diefill::process::estimate {

/// A law of discharge with what it was fitted to.
struct PowderDischarge {
  continuum::TransientCoefficients numbers;
  double longest = 0;  ///< t sqrt(g/D) - 1/5 up to which it was measured; the rate is constant beyond
  /// m, of the grains that feel its openings as they are; 1.4 times what others have more is taken off.
  double grain_diameter = 0;
  /// Bond number up to which it was compared with flows; infinite where it is a fit to the powder itself.
  double largest_bond = std::numeric_limits<double>::infinity();
  std::string of_bond;               ///< which flows that were
  std::string source;                ///< of the numbers
  std::string applies;               ///< how well they fit this powder, as text
  std::string remark;                ///< what to beware of, one line; empty: nothing
  std::vector<std::string> doubts;   ///< why it may be none of this powder, a line each
  bool holds_beyond_longest = true;  ///< false: it was fitted to flows that show no steady rate
};

/// The law for a preset or a powder of one's own.
PowderDischarge discharge_of(const PowderSpec& powder);

/// The law that `diefill fit-discharge` wrote to `file` (fit.json): 5.17, transient, 5.18 as the 5.17 nearest
/// to it, beverloo-slit with the beginning of the published flow. Throws SceneError for another one and where
/// it is none.
PowderDischarge read_discharge(const std::filesystem::path& file);

/// f_B(x) with the rate kept beyond `longest`; 0 for x < 0, when nothing has run out yet.
double discharged_share(const PowderDischarge& law, double x);

}  // namespace diefill::process::estimate
