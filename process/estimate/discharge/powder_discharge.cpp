#include "process/estimate/discharge/powder_discharge.h"

#include <algorithm>

#include "process/scene/powder/grain_models.h"
#include "process/scene/powder/powder_presets.h"
#include "process/scene/powder/unchanged_preset.h"

namespace diefill::process::estimate {

namespace {

/// m, of ASC100.29 (Bierwisch 2009, section 4.1.3: a box of 5 cm is about 500 grains wide).
constexpr double kRealGrain = 1e-4;
/// x of a slit of 10 mm at 0.1 m/s, the slowest and widest that was measured (Bierwisch 2009, section 4.1.1).
constexpr double kLongestMeasured = 2.9;

/// x of a slit of 10 mm after the 0.3 s that its outflow was recorded for (Bierwisch 2009, section 5.2.1).
constexpr double kLongestSimulated = 9;

/// Bond numbers of the most cohesive powders that the laws were held against: ASC100.29 D2, which runs 1.1 to
/// 1.3 times slower than its law (process/estimate/README.md), and the models fitted to the measured
/// discharge.
constexpr double kComparedBond = 2.5, kFittedBond = 60;

bool one_of(const std::string& name, std::initializer_list<const char*> names) {
  return std::any_of(names.begin(), names.end(), [&](const char* known) { return name == known; });
}

}  // namespace

PowderDischarge discharge_of(const PowderSpec& powder) {
  PowderDischarge law;
  const bool as_published = is_unchanged_preset(powder);
  if (powder.model == GrainModel::D && powder.name != "ASC100.29 D1") {
    law.numbers = continuum::kSimulatedDischarge;
    law.longest = kLongestSimulated;
    law.grain_diameter = 6 * facts_of(GrainModel::D).sphere_radius;
    law.largest_bond = kComparedBond;
    law.of_bond = "runs of ASC100.29 D2";
    law.source = "hopper of model D grains, friction 0.5, no cohesion (Bierwisch 2009, Table 5.2)";
    law.applies = "grains of the same shape; more friction and cohesion let less run in";
    if (as_published && powder.name == "Distaloy AE")
      law.applies = "compared with this powder (process/estimate/README.md)";
    return law;
  }
  law.numbers = continuum::kMeasuredDischarge;
  law.longest = kLongestMeasured;
  law.grain_diameter = kRealGrain;
  law.largest_bond = kFittedBond;
  law.of_bond = "models of ASC100.29 fitted to it";
  law.source = "discharge of ASC100.29 through a slit of 6 mm (Bierwisch 2009, Table 4.1)";
  if (as_published && one_of(powder.name, {"ASC100.29 A1", "ASC100.29 B1", "ASC100.29 C1", "ASC100.29 D1"}))
    law.applies = "this model powder was fitted to that discharge";
  else if (as_published && powder.name.starts_with("ASC100.29"))
    law.applies = "the same powder; this model of it was not fitted to its discharge and runs faster";
  else
    law.applies = "another powder: measure yours and use diefill fit-discharge";
  return law;
}

double discharged_share(const PowderDischarge& law, double x) {
  if (x < 0) return 0;
  if (x <= law.longest) return continuum::discharged_share(law.numbers, x);
  return continuum::discharged_share(law.numbers, law.longest) +
         continuum::rate_share(law.numbers, law.longest) * (x - law.longest);
}

}  // namespace diefill::process::estimate
