#include "process/tooling/examination/tool_fit.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <utility>

#include "process/results/rounding.h"

namespace diefill::process {

namespace {

constexpr double kLargestTool = 2;       // m
constexpr double kAbsurdDistance = 1e6;  // m, a fault in the file: not to be shifted back
constexpr double kFarthestTool = 20;     // m, middle from the origin of the scene
constexpr double kLeastOverRadius =
    4;  // a tool's longest side, over the radius of wall spheres that cover it
constexpr double kSmallestUsual = 0.01, kLargestUsual = 0.8;  // m, extents of tools that presses have

/// Share of a part's size to which its depth in another is found where no corner shows it.
constexpr double kResolutionOverSize = 1.0 / 200;

void deepen(geometry::Penetration& deepest, const Tool& part, const Tool& other, double resolution) {
  const geometry::Box box = other.mesh.bounding_box();
  const double least = kResolutionOverSize * part.mesh.bounding_box().size().norm();
  const auto found =
      geometry::deepest_penetration(part.mesh, other.solid(), box, std::max(resolution, least));
  if (found.depth > deepest.depth) deepest = found;
}

/// Depth of the points tested beneath each triangle, over the part's size.
constexpr double kBeneathOverSize = 1e-4;

/// Whether the part is the other, or one of its bodies, at the same place: the points just beneath all of its
/// triangles then lie in the other, which they do not where parts only touch or overlap slightly.
bool is_same_body(const Tool& part, const Tool& other) {
  const double beneath = kBeneathOverSize * part.mesh.bounding_box().size().norm();
  bool any = false;
  for (const Eigen::Vector3i& triangle : part.mesh.triangles) {
    const Eigen::Vector3d &a = part.mesh.vertices[static_cast<std::size_t>(triangle[0])],
                          &b = part.mesh.vertices[static_cast<std::size_t>(triangle[1])],
                          &c = part.mesh.vertices[static_cast<std::size_t>(triangle[2])];
    const Eigen::Vector3d outward = (b - a).cross(c - a);
    if (outward.norm() < beneath * beneath) continue;  // too small to say where its inside is
    any = true;
    if (!other.solid().inside((a + b + c) / 3 - beneath * outward.normalized())) return false;
  }
  return any;
}

/// Units in which the part would be as large as tools are, where `extent` is in the file's unit.
std::string likely_unit(double extent) {
  std::string units;
  for (const auto& [name, metres] :
       {std::pair{"mm", 1e-3}, {"um", 1e-6}, {"cm", 1e-2}, {"m", 1.0}, {"inch", 0.0254}}) {
    char text[60];
    const double size = extent * metres;
    if (size < kSmallestUsual || size > kLargestUsual) continue;
    std::snprintf(text, sizeof text, "%s%.4g mm in \"%s\"", units.empty() ? " (" : ", ", 1e3 * size, name);
    units += text;
  }
  return units.empty() ? "" : units + ")";
}

/// Space is searched between all tools; and so far away single precision, as CAD files have it, is coarse.
void refuse_far(const geometry::Mesh& mesh, const std::string& where) {
  const geometry::Box box = mesh.bounding_box();
  const Eigen::Vector3d middle = (box.lower + box.upper) / 2;
  if (middle.cwiseAbs().maxCoeff() <= kFarthestTool) return;
  if (!(middle.cwiseAbs().maxCoeff() <= kAbsurdDistance))
    throw SceneError(where +
                     ": is more than 1000 km from the origin, allowed: up to 20 m; check the coordinates " +
                     "in the CAD file and its length_unit");
  // The axes along which the tool is near are left as they are in CAD.
  Eigen::Vector3d back = Eigen::Vector3d::Zero();
  for (int k = 0; k < 3; ++k)
    if (std::abs(middle[k]) > kLargestTool) back[k] = -middle[k];
  char text[400];
  std::snprintf(text, sizeof text,
                ": is %.4g m from the origin, allowed: up to %.4g m, because distant coordinates lose digits "
                "in single-precision CAD files (steps of %.2g mm); move it to the origin in CAD, or add "
                "[\"%.9g mm\", \"%.9g mm\", \"%.9g mm\"] to its position",
                middle.norm(), kFarthestTool, 1e3 * middle.norm() * std::numeric_limits<float>::epsilon(),
                1e3 * back[0], 1e3 * back[1], 1e3 * back[2]);
  throw SceneError(where + text);
}

/// What to do where the unit is wrong of a tool with that longest side (m).
std::string unit_text(const FileUnit& unit, double longest) {
  return (unit.stated ? "its CAD file states its unit: export it again in the unit that it is drawn in"
                      : "check whether length_unit is that of the CAD file") +
         likely_unit(longest / unit.metres);
}

/// Of a radius that is too large for a tool with that longest side (m).
std::string radius_text(const WallRadius& radius, double longest) {
  char text[200];
  std::snprintf(text, sizeof text,
                "%s is %.4g mm, allowed for this tool: 0.001 mm to %.4g mm, a quarter of its longest side",
                radius.key.c_str(), 1e3 * radius.metres, std::floor(1e6 * longest / kLeastOverRadius) / 1e3);
  return text;
}

}  // namespace

void check_size(const geometry::Mesh& mesh, const WallRadius& radius, const FileUnit& unit,
                const std::string& where) {
  const Eigen::Vector3d size = mesh.bounding_box().size();
  const bool too_large = size.maxCoeff() > kLargestTool,
             too_small = size.maxCoeff() < kLeastOverRadius * radius.metres;
  if (!too_large) refuse_far(mesh, where);  // a tool of 200 m is far away only because of its unit
  if (!too_large && !too_small) return;
  const auto millimetres = [&](int k) { return results::in_significant_digits(1e3 * size[k], 4); };
  const std::string measures =
      "measures " + millimetres(0) + " x " + millimetres(1) + " x " + millimetres(2) + " mm";
  if (!too_large && size.maxCoeff() >= kLeastOverRadius * WallSpec{}.sphere_radius)
    throw SceneError(where + ": " + radius_text(radius, size.maxCoeff()) + "; the tool " + measures +
                     (size.maxCoeff() < kSmallestUsual ? ", or " + unit_text(unit, size.maxCoeff()) : ""));
  throw SceneError(where + ": " + measures + ", " +
                   (too_large ? "allowed: up to 2000 mm" : "too small to be covered with wall spheres") +
                   "; " + unit_text(unit, size.maxCoeff()));
}

geometry::Penetration deepest_overlap(const Tool& one, const Tool& other, double resolution) {
  geometry::Penetration deepest;
  deepen(deepest, one, other, resolution);
  deepen(deepest, other, one, resolution);
  return deepest;
}

void check_fit(const Tool& tool, const Tool& other, double sphere_radius, const std::string& where) {
  const geometry::Penetration deepest = deepest_overlap(tool, other, sphere_radius);
  if (deepest.depth <= sphere_radius) {
    if (!is_same_body(tool, other) && !is_same_body(other, tool)) return;
    throw SceneError(where + " and tool \"" + other.spec.name +
                     "\" are the same body at the same place; give one of them another file, part or "
                     "position, or remove it");
  }
  char text[120];
  std::snprintf(text, sizeof text,
                " overlap by %.3g mm near (%.2f, %.2f, %.2f) mm at the start; move one of them",
                1e3 * deepest.depth, 1e3 * deepest.place[0], 1e3 * deepest.place[1], 1e3 * deepest.place[2]);
  throw SceneError(where + " and tool \"" + other.spec.name + "\"" + text);
}

}  // namespace diefill::process
