#include "process/tradeoff/parameters/parameters.h"

namespace diefill::process {
namespace {

/// Axis of the slice: y where the scene is periodic along both, since tools move along x.
std::optional<Eigen::Index> slice_axis(const Scene& scene) {
  if (scene.numerics.period[1]) return 1;
  if (scene.numerics.period[0]) return 0;
  return std::nullopt;
}

double length_of(const Scene& scene, Eigen::Index axis) {
  return *scene.numerics.period[static_cast<std::size_t>(axis)];
}

std::string current(const Scene& scene) {
  const auto axis = slice_axis(scene);
  return axis ? in_millimetres(length_of(scene, *axis)) : "not periodic";
}

std::vector<std::string> usual(const Scene& scene) {
  const auto axis = slice_axis(scene);
  if (!axis) return {};
  return {in_millimetres(0.5 * length_of(scene, *axis)), in_millimetres(2 * length_of(scene, *axis))};
}

std::string toml_point(const Eigen::Vector3d& point) {
  std::string text = "[";
  for (const double coordinate : point) text += '"' + in_millimetres(coordinate) + "\", ";
  return text.substr(0, text.size() - 2) + ']';
}

/// The pour keeps its share of the slice, so that powder stands as high as before.
SceneChanges changes(const Scene& scene, const std::string& value) {
  const auto axis = slice_axis(scene);
  if (!axis) throw SceneError("the scene is not periodic; set numerics.periodic or remove the parameter");
  const double factor = parse_quantity(value, Dimension::length) / length_of(scene, *axis);
  Eigen::Vector3d from = scene.pour.lower, to = scene.pour.upper;
  from[*axis] *= factor;
  to[*axis] *= factor;
  return {std::string("numerics.periodic.") + (*axis == 1 ? "y" : "x") + " = " + toml_value(value) +
              "\npour.from = " + toml_point(from) + "\npour.to = " + toml_point(to) + '\n',
          {}};
}

}  // namespace

Parameter slice_length_parameter() {
  return {.name = "slice_length",
          .label = "length of the periodic slice",
          .sign = "slice",
          .finer = Finer::larger,
          .dimension = Dimension::length,
          .current = current,
          .usual = usual,
          .changes = changes};
}

}  // namespace diefill::process
