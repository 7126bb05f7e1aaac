// Several powders in one scene: [[other_powder]] beside [powder], what acts between grains of different
// powders ([[powder_pair]]), and layers of the poured powder.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "process/scene/powder/powder_spec.h"

namespace diefill::process {

struct ContactSpec;
struct PairLawSpec;
struct Scene;

/// A powder beside [powder].
struct OtherPowder {
  PowderSpec powder;
  double share = 0;                             ///< of the mass where powders are mixed; 0: of no mixture
  std::optional<double> wall_friction;          ///< none: that of [walls]
  std::optional<double> wall_work_of_adhesion;  ///< J/m^2; none: that of [walls]
  std::shared_ptr<const ContactSpec> contact;   ///< laws of its grains; null: the scene has no [contact]
};

/// What acts between grains of two powders.
struct PowderPair {
  std::size_t first = 0, second = 0;  ///< numbers of the powders, 0: [powder]
  /// Means of the two powders' parameters, or what [[powder_pair]] gives (mean_powder()).
  PowderSpec powder;
  std::shared_ptr<const PairLawSpec> contact;  ///< null: the scene has no [contact]
};

/// One layer of the poured powder.
struct PourLayer {
  std::size_t powder = 0;  ///< number
  double share = 0;        ///< of the fill height
};

/// Parameters for contacts between grains of two powders where nothing else is said: harmonic mean of the
/// reduced moduli (springs of both in series), geometric mean of works of adhesion (Berthelot's rule),
/// arithmetic means of friction, damping and tangential stiffness over radius [assumed], no rolling friction
/// unless both have it. The factor of coarse graining is the geometric mean.
PowderSpec mean_powder(const PowderSpec& first, const PowderSpec& second);

/// For people, such as "2 % by mass, grains of d = 1.4 mm".
std::string amount_text(const Scene& scene, const OtherPowder& other);

/// Names of all powders, such as "iron, copper".
std::string powder_names(const Scene& scene);
/// Number of the powder of that name; nothing where there is none.
std::optional<std::size_t> powder_named(const Scene& scene, const std::string& name);
/// By number, 0: [powder].
const PowderSpec& powder_of(const Scene& scene, std::size_t number);

}  // namespace diefill::process
