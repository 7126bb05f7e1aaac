#include "process/tooling/examination/tool_scale.h"

#include <cmath>
#include <cstdio>

namespace diefill::process {

namespace {

std::string unit_named(double metres) {
  for (const auto& [name, length] :
       {std::pair{"mm", 1e-3}, {"cm", 1e-2}, {"m", 1.0}, {"inch", 0.0254}, {"um", 1e-6}})
    if (std::abs(metres / length - 1) < 1e-6) return name;
  return "";
}

}  // namespace

std::vector<double> unit_factors() {
  return {25.4, 10, 1000, 1 / 25.4, 0.1, 1e-3, 1e6, 1e-6};
}

geometry::Mesh rescaled(const Tool& tool, double factor) {
  geometry::Mesh mesh = tool.mesh;
  for (auto& vertex : mesh.vertices) vertex = tool.spec.position + factor * (vertex - tool.spec.position);
  return mesh;
}

std::string unit_advice(const Tool& tool, double factor) {
  const Eigen::Vector3d size = 1e3 * tool.mesh.bounding_box().size();
  const std::string unit = unit_named(factor * tool.metres_per_unit);
  char text[300];
  std::snprintf(text, sizeof text,
                "tool \"%s\" (line %d) measures %.4g x %.4g x %.4g mm, too %s for the other tools by a "
                "factor of %.4g",
                tool.spec.name.c_str(), tool.spec.line, size[0], size[1], size[2],
                factor > 1 ? "small" : "large", factor > 1 ? factor : 1 / factor);
  if (unit.empty()) return text + std::string("; check the unit of its file");
  return text + (": its file seems to be in " + unit) +
         (tool.unit_from_file ? ", but states another unit; export it again in " + unit
                              : "; write length_unit = \"" + unit + "\"");
}

}  // namespace diefill::process
