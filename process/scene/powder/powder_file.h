// `powder.file` of a scene: a powder kept in a file of its own, such as `diefill calibrate` writes, with what
// it was fitted with.
#pragma once

#include <toml++/impl/forward_declarations.h>

#include <filesystem>
#include <string>
#include <vector>

#include "process/input/table_reader.h"
#include "process/scene/scene.h"

namespace diefill::process {

/// Where [powder] of the document has a `file`, lays what that file says under the document: keys of [powder]
/// and [walls] that the document does not give itself, and [contact] where it has none. Returns whether there
/// was one; the document then stands alone. Throws SceneError for a file that is missing or wrong, and for
/// keys that would make another powder of it.
bool merge_powder_file(toml::table& document, const std::filesystem::path& scene_file);

/// Makes a relative `spheres_file` of the document's [powder], which is one beside `file`, absolute: the
/// table is to stand in a file elsewhere.
void make_spheres_file_absolute(toml::table& document, const std::filesystem::path& file);

/// What a calibrated powder's parameters belong to: they are worth less with other walls or stiffness.
struct FittedWith {
  double grain_diameter = 0;   ///< m
  double reduced_modulus = 0;  ///< Pa
  WallKind wall_kind = WallKind::spheres;
  double wall_sphere_radius = 0;  ///< m
  double wall_spacing = 0;        ///< over that radius
  std::string contact;            ///< number of [contact] (contact_number); empty: it had none
  std::string program;            ///< version
};

/// [powder.fitted_with]; nothing where the powder has none.
std::optional<FittedWith> read_fitted_with(TableReader& powder);

/// The same as TOML, and of a scene as it stands.
std::string fitted_with_text(const FittedWith& fitted);
FittedWith fitted_with_of(const Scene& scene, const std::string& program_version);

/// One line where the scene's walls or stiffness differ from those that its powder was fitted with;
/// empty otherwise.
std::string fitted_with_warning(const Scene& scene);

}  // namespace diefill::process
