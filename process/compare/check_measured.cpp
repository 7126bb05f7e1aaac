#include "process/compare/check_measured.h"

#include <optional>

#include "geometry/mesh/mesh.h"
#include "process/input/scene_error.h"
#include "process/measure/fields/measured_fields.h"
#include "process/measured_data/fields_of_shape.h"
#include "process/setup/read_tooling.h"

namespace diefill::process {
namespace {

/// Names of the scene's sections; the one that results have where it asks for none.
std::vector<std::string> sections_of(const Scene& scene) {
  std::vector<std::string> names;
  for (const SectionSpec& section : scene.measure.sections) names.push_back(section.name);
  return names.empty() ? std::vector<std::string>{kDefaultSection} : names;
}

/// Those of the scene; empty, as not known, for tools that cannot be used: its run will say so.
std::vector<bool> rings_if_known(const Scene& scene, const ProgressCallback& on_progress) {
  try {
    return rings_of(scene, on_progress);
  } catch (const SceneError&) {
    return {};
  } catch (const geometry::MeshError&) {
    return {};
  }
}

/// A variant with its cavities, which are read when first asked for.
class CheckedVariant {
 public:
  CheckedVariant(const Scene& scene, const ProgressCallback& on_progress)
      : scene_(scene), on_progress_(on_progress) {}

  /// Throws SceneError where results of this variant cannot have what the table holds.
  void check(const MeasuredTable& table) {
    refuse_unknown_field(table, sections_of(scene_));
    if (!rings_) rings_ = rings_if_known(scene_, on_progress_);
    if (!rings_->empty()) refuse_field_of_other_shape(table, table.value.name, *rings_);
  }

 private:
  const Scene& scene_;
  const ProgressCallback& on_progress_;
  std::optional<std::vector<bool>> rings_;
};

/// Why the first variant cannot have what was measured; nothing where one of them can.
std::optional<SceneError> refused_by_all(const MeasuredTable& table, std::vector<CheckedVariant>& variants) {
  std::optional<SceneError> first;
  for (CheckedVariant& variant : variants) {
    try {
      variant.check(table);
      return std::nullopt;
    } catch (const SceneError& error) {
      if (!first) first = error;
    }
  }
  return first;
}

}  // namespace

std::vector<bool> rings_of(const Scene& scene, const ProgressCallback& on_progress) {
  const Tooling tooling = read_tooling(scene, on_progress);
  if (!tooling.cavity.found) return {};
  std::vector<bool> rings = {tooling.cavity.is_ring};
  for (const auto& other : tooling.other_cavities) rings.push_back(other.is_ring);
  return rings;
}

void refuse_unmeasurable(const std::vector<MeasuredFile>& files, const std::vector<Variant>& variants,
                         const ProgressCallback& on_progress) {
  std::vector<CheckedVariant> checked;
  for (const Variant& variant : variants) checked.emplace_back(variant.scene, on_progress);
  for (const MeasuredFile& file : files)
    if (const auto refused = refused_by_all(file.table, checked)) throw *refused;
}

}  // namespace diefill::process
