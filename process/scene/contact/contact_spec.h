// What [contact] states: the laws between grains and between grains and tools, as engine parameters and as
// text.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/laws/law_parameters.h"
#include "process/input/table_reader.h"
#include "process/scene/scene.h"

namespace diefill::process {

/// One part of a law, for reports.
struct PartDescription {
  std::string kind;  ///< such as "damping"
  std::string text;  ///< such as "restitution (restitution 0.5)"; "none"
};

/// The law of one pair of materials.
struct PairLawSpec {
  engine::laws::LawParameters law;     ///< at the powder's own grain size, SI units
  std::vector<PartDescription> parts;  ///< normal, damping, friction, rolling, attraction
};

/// The default rule of coarse graining (Bierwisch 2009, chapter 3), the first of
/// engine::coarse_graining::kParameterRules. Other rules: the rest of them, and kMethods, which scale forces.
inline constexpr const char* kBierwischScaling = "bierwisch";

struct ContactSpec {
  PairLawSpec grains, walls;
  std::string coarse_graining = kBierwischScaling;  ///< the rule by its name
};

/// [contact] of a document, or nothing: Bierwisch's law of the powder. `powder` and `walls` give what its
/// parts leave out. Throws SceneError, also for keys of [powder], [walls] and [numerics] without effect
/// beside it.
std::optional<ContactSpec> read_contact(TableReader& document, const PowderSpec& powder,
                                        const WallSpec& walls);

/// The law of one tool beside [contact]: the parts that [tool.contact] names, otherwise those of
/// [contact.walls] and [contact], with the tool's own friction and adhesion. Nothing where the tool is as
/// [contact.walls] says. `table`: of the tool. Throws SceneError.
std::shared_ptr<const PairLawSpec> read_tool_contact(TableReader& document, TableReader& table,
                                                     const ToolSpec& tool, const PowderSpec& powder,
                                                     const WallSpec& walls);

/// Laws of [[other_powder]] and of the scene's pairs of powders under [contact].
struct OtherContacts {
  std::vector<std::shared_ptr<const ContactSpec>> powders;  ///< null: the scene has no [contact]
  std::vector<std::shared_ptr<const PairLawSpec>> pairs;    ///< the same
};

/// The parts that `step_contact` (null: none) names, otherwise those of the powder's or the pair's own
/// `contact`, otherwise those of [contact]. `scene` has its powders and pairs. Throws SceneError.
OtherContacts read_other_contacts(TableReader& document, TableReader* step_contact, const Scene& scene);

/// The step with the laws of its [step.contact], where it is of kind "change": the parts that the table names
/// in place of those of [contact]; otherwise the step itself. Throws SceneError, also for coefficients that
/// the laws in use have not.
std::shared_ptr<const Step> with_contact_of(TableReader& document, TableReader& step_table,
                                            std::shared_ptr<const Step> step, const Scene& scene);

}  // namespace diefill::process
