// One reader for each table of a scene file. Each fetches its keys, checks them, and rejects unknown ones.
#pragma once

#include <string>
#include <vector>

#include "process/input/table_reader.h"
#include "process/scene/scene.h"

namespace diefill::process {

/// The scene in a parsed document; `text` and `file` are kept in it, and `file` stands in messages. Where its
/// powder stands in a file of its own (powder_file.h) the document takes it over, and the scene's text is
/// that of the whole document. Messages name values of changes (`written`) as the changes do.
Scene scene_of(toml::table& parsed, const std::string& text, const std::filesystem::path& file,
               const WrittenKeys& written = {});

/// `coarse_graining` of [powder]; to be read before the rest, which rejects keys that were not requested.
CoarseGraining read_coarse_graining(TableReader& table);
/// The rest of [powder]: a preset, a preset with overrides, or a powder of its own.
PowderSpec read_powder(TableReader& table);
/// [powder.sizes], where it is there, into the powder: its classes and the grain size of mean mass.
void read_sizes(TableReader& powder_table, PowderSpec& powder);
/// [[other_powder]] and [[powder_pair]] into a scene that has its powder, walls and contact.
void read_other_powders(TableReader& document, Scene& scene);
/// Number of the pair (Scene::powder_pairs) that a [[powder_pair]] names.
std::size_t named_pair(TableReader& table, const Scene& scene);
/// `layers` of [pour].
std::vector<PourLayer> read_layers(TableReader& pour, const Scene& scene);
/// Refuses powders without a share where they are mixed, and inflow of no powder in particular where they are
/// not. The scene has its pour and steps.
void check_mixture(TableReader& document, const Scene& scene);
/// [walls]; the powder must not fit through the holes between wall spheres.
WallSpec read_walls(TableReader table, const PowderSpec& powder);
/// All [[tool]] tables.
std::vector<ToolSpec> read_tools(TableReader& document, const WallSpec& walls, const PowderSpec& powder);
/// [numerics].
NumericsSpec read_numerics(TableReader table, const PowderSpec& powder);
/// [pour], of a scene that has its powders and numerics.
PourSpec read_pour(TableReader table, const Scene& scene);
/// All [[step]] tables.
std::vector<std::shared_ptr<const Step>> read_steps(TableReader& document,
                                                    const std::vector<ToolSpec>& tools);
/// All [[probe]] tables.
std::vector<ProbeSpec> read_probes(TableReader& document, const std::vector<ToolSpec>& tools);
/// All [[snapshot]] tables; `scene` has its tools and steps already.
std::vector<SnapshotSpec> read_snapshots(TableReader& document, const Scene& scene);
/// [economy], into a scene that has everything else: where half the scene is computed, half of [pour] stays.
void read_economy(TableReader table, Scene& scene);
/// [suction], of a scene that has everything else.
SuctionSpec read_suction(TableReader& table, const Scene& scene);
/// [measure], of a scene with this powder.
MeasureSpec read_measure(TableReader table, const PowderSpec& powder);

}  // namespace diefill::process
