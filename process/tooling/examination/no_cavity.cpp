#include "process/tooling/examination/no_cavity.h"

#include <Eigen/Geometry>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "geometry/cavity/side_opening.h"
#include "process/results/formatted.h"
#include "process/tooling/examination/tool_fit.h"
#include "process/tooling/examination/tool_scale.h"

namespace diefill::process {

namespace {

constexpr double kFit = 2e-4;    // m, the widest gap that counts as closed (geometry/cavity/cavity.h)
constexpr double kPlate = 1e-3;  // m, thickness of a plate put below on trial

/// The tools that can enclose a cavity, as they stand in the end.
struct Standing {
  const Scene& scene;
  const Tooling& tooling;
  std::vector<std::size_t> tools;      ///< numbers
  std::vector<geometry::Mesh> meshes;  ///< laboratory frame
  std::size_t die = 0;                 ///< place of the die in both
};

Standing standing_of(const Scene& scene, const Tooling& tooling, const std::vector<ToolPose>& poses) {
  Standing standing{scene, tooling, {}, {}, 0};
  for (std::size_t k = 0; k < tooling.tools.size(); ++k) {
    if (tooling.tools[k].spec.role == ToolRole::shoe) continue;
    if (k == tooling.die) standing.die = standing.tools.size();
    standing.tools.push_back(k);
    standing.meshes.push_back(
        geometry::transformed(tooling.tools[k].mesh, poses[k].rotation, poses[k].translation));
  }
  return standing;
}

bool encloses(const std::vector<geometry::Mesh>& meshes, double fill_plane) {
  std::vector<const geometry::Mesh*> solids;
  for (const auto& mesh : meshes) solids.push_back(&mesh);
  return geometry::find_cavity(solids, fill_plane).found;
}

std::string range(const char* axis, double from, double to) {
  return results::formatted("%s = %.4g to %.4g mm", axis, 1e3 * from, 1e3 * to);
}

std::string in_z(const geometry::Box& box) {
  return range("z", box.lower.z(), box.upper.z());
}

bool meet(const geometry::Box& one, const geometry::Box& other, double nearest) {
  for (Eigen::Index axis = 0; axis < 2; ++axis)
    if (one.lower[axis] > other.upper[axis] + nearest || other.lower[axis] > one.upper[axis] + nearest)
      return false;
  return true;
}

/// Whether the tool of that number would fit with the others were it `factor` times as large.
bool fits_rescaled(const Standing& standing, std::size_t which, double factor) {
  const Tool& tool = standing.tooling.tools[standing.tools[which]];
  auto meshes = standing.meshes;
  meshes[which] = rescaled(tool, factor);
  const double plane =
      standing.scene.measure.fill_plane.value_or(meshes[standing.die].bounding_box().upper.z());
  double largest = 0;
  for (std::size_t k = 0; k < meshes.size(); ++k)
    if (k != which) largest = std::max(largest, meshes[k].bounding_box().size().maxCoeff());
  const double size = meshes[which].bounding_box().size().maxCoeff();
  if (std::abs(std::log(size / largest)) >= std::abs(std::log(size / factor / largest)) ||
      size > 20 * largest || size < largest / 20 || !encloses(meshes, plane))
    return false;
  Tool grown;
  grown.mesh = meshes[which];
  for (std::size_t k = 0; k < meshes.size(); ++k) {
    if (k == which) continue;
    Tool other;
    other.mesh = meshes[k];
    const double allowed = standing.scene.walls.sphere_radius;
    if (deepest_overlap(grown, other, allowed).depth > allowed) return false;
  }
  return true;
}

std::string wrong_unit(const Standing& standing) {
  if (standing.tools.size() < 2) return "";
  for (std::size_t which = 0; which < standing.tools.size(); ++which)
    for (const double factor : unit_factors())
      if (fits_rescaled(standing, which, factor))
        return unit_advice(standing.tooling.tools[standing.tools[which]], factor);
  return "";
}

/// The fill plane belongs to the top of the die: machine coordinates put it elsewhere.
std::string wrong_fill_plane(const Standing& standing) {
  const geometry::Box die = standing.meshes[standing.die].bounding_box();
  const double plane = standing.tooling.fill_plane;
  if (std::abs(plane - die.upper.z()) < kFit || !encloses(standing.meshes, die.upper.z())) return "";
  char text[240];
  std::snprintf(text, sizeof text,
                "measure.fill_plane is %.4g mm, but die \"%s\" is at %s: a fill plane at its top gives a "
                "cavity; write fill_plane = \"%.6g mm\", or remove the key",
                1e3 * plane, standing.tooling.tools[standing.tooling.die].spec.name.c_str(),
                in_z(die).c_str(), 1e3 * die.upper.z());
  return text;
}

/// One way of drawing tools that are to be turned: about which axis by how much.
struct Turn {
  const char* drawn;
  const char* axis;
  double degrees;
  Eigen::Vector3d direction;
};

std::string turned(const Standing& standing) {
  const Turn turns[] = {{"with y up", "x", 90, Eigen::Vector3d::UnitX()},
                        {"upside down", "x", 180, Eigen::Vector3d::UnitX()},
                        {"with y down", "x", -90, Eigen::Vector3d::UnitX()},
                        {"with x up", "y", -90, Eigen::Vector3d::UnitY()},
                        {"with x down", "y", 90, Eigen::Vector3d::UnitY()}};
  for (const Turn& turn : turns)
    for (const bool die_alone : {false, true}) {
      if (die_alone && standing.meshes.size() == 1) continue;
      auto meshes = standing.meshes;
      for (std::size_t k = 0; k < meshes.size(); ++k)
        if (!die_alone || k == standing.die) {
          const Eigen::Vector3d& at = standing.tooling.tools[standing.tools[k]].spec.position;
          const Eigen::Matrix3d rotation =
              Eigen::AngleAxisd(turn.degrees * std::numbers::pi / 180, turn.direction).toRotationMatrix();
          meshes[k] = geometry::transformed(meshes[k], rotation, at - rotation * at);
        }
      if (!encloses(meshes, meshes[standing.die].bounding_box().upper.z())) continue;
      char text[300];
      std::snprintf(text, sizeof text,
                    "%s drawn %s: a rotation by %g deg about %s gives a cavity; write rotation = { axis = "
                    "\"%s\", angle = \"%g deg\" } at %s, and z is up",
                    die_alone ? "the die seems to be" : "the tools seem to be", turn.drawn, turn.degrees,
                    turn.axis, turn.axis, turn.degrees, die_alone ? "it" : "each tool");
      return text;
    }
  return "";
}

/// The hole that a plate below the die would make a cavity; not found for a solid block.
geometry::Cavity hole_in_die(const Standing& standing) {
  const geometry::Box box = standing.meshes[standing.die].bounding_box();
  geometry::Mesh plate;
  const double low = box.lower.z() - kPlate, high = box.lower.z() + 1e-6;
  for (int corner = 0; corner < 8; ++corner)
    plate.vertices.emplace_back((corner & 1) != 0 ? box.upper.x() : box.lower.x(),
                                (corner & 2) != 0 ? box.upper.y() : box.lower.y(),
                                (corner & 4) != 0 ? high : low);
  plate.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                     {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return geometry::find_cavity({&standing.meshes[standing.die], &plate}, box.upper.z());
}

/// Why this punch does not close the hole.
std::string punch_text(const Standing& standing, std::size_t which, const geometry::Cavity& hole) {
  const geometry::Box punch = standing.meshes[which].bounding_box();
  const geometry::Box die = standing.meshes[standing.die].bounding_box();
  const std::string name = "punch \"" + standing.tooling.tools[standing.tools[which]].spec.name + "\"";
  char text[300];
  if (!meet(punch, hole.box, 0)) {
    std::snprintf(text, sizeof text,
                  " is beside the hole of the die (%s, %s; the hole: %s, %s); move it into the hole",
                  range("x", punch.lower.x(), punch.upper.x()).c_str(),
                  range("y", punch.lower.y(), punch.upper.y()).c_str(),
                  range("x", hole.box.lower.x(), hole.box.upper.x()).c_str(),
                  range("y", hole.box.lower.y(), hole.box.upper.y()).c_str());
  } else if (punch.upper.z() < die.lower.z()) {
    std::snprintf(text, sizeof text,
                  " is too low: its top is at z = %.4g mm, %.4g mm below the die, which is at %s; raise it "
                  "by more than that",
                  1e3 * punch.upper.z(), 1e3 * (die.lower.z() - punch.upper.z()), in_z(die).c_str());
  } else if (punch.upper.z() >= standing.tooling.fill_plane - kFit) {
    std::snprintf(text, sizeof text,
                  " fills the hole: its top is at z = %.4g mm, the fill plane at z = %.4g mm; lower the "
                  "punch by the cavity depth",
                  1e3 * punch.upper.z(), 1e3 * standing.tooling.fill_plane);
  } else {
    const Eigen::Vector3d play = 1e3 * (hole.box.size() - punch.size());
    std::snprintf(text, sizeof text,
                  " leaves the hole open: the hole measures %.4g x %.4g mm, the punch %.4g x %.4g mm, %.3g "
                  "and %.3g mm less, and gaps above %.1f mm count as open; widen or move the punch",
                  1e3 * hole.box.size().x(), 1e3 * hole.box.size().y(), 1e3 * punch.size().x(),
                  1e3 * punch.size().y(), play.x(), play.y(), 1e3 * kFit);
  }
  return name + text;
}

/// A punch or core rod that stands above the hole of the die, as where the press ejects.
std::string lifted_out(const Standing& standing) {
  const geometry::Cavity hole = hole_in_die(standing);
  if (!hole.found) return "";
  const double top = standing.meshes[standing.die].bounding_box().upper.z();
  for (std::size_t k = 0; k < standing.tools.size(); ++k) {
    const ToolSpec& spec = standing.tooling.tools[standing.tools[k]].spec;
    const bool is_punch = spec.role == ToolRole::punch;
    if (k == standing.die || (!is_punch && spec.role != ToolRole::core)) continue;
    const geometry::Box box = standing.meshes[k].bounding_box();
    if (box.lower.z() < top - kFit || !meet(box, hole.box, 0)) continue;
    return results::formatted(
        "%s \"%s\" stands above the die: it is at %s, its lower end %.4g mm above the top of the die at z = "
        "%.4g mm; lower it into the hole, by its position or by a step before this one%s",
        is_punch ? "punch" : "core", spec.name.c_str(), in_z(box).c_str(),
        1e3 * std::max(0.0, box.lower.z() - top), 1e3 * top,
        is_punch ? ", so that its top is the floor of the cavity" : "");
  }
  return "";
}

/// A punch that reaches up to the fill plane in the hole of the die. Turned upside down the die would stand
/// above it, with a cavity that nobody means.
std::string filled_by_punch(const Standing& standing) {
  const geometry::Cavity hole = hole_in_die(standing);
  if (!hole.found) return "";
  for (std::size_t k = 0; k < standing.tools.size(); ++k) {
    if (standing.tooling.tools[standing.tools[k]].spec.role != ToolRole::punch) continue;
    const geometry::Box punch = standing.meshes[k].bounding_box();
    const bool inside = (punch.size() - hole.box.size()).head<2>().maxCoeff() <= kFit;
    const bool reaches_up = punch.upper.z() >= standing.tooling.fill_plane - kFit;
    if (inside && reaches_up && punch.lower.z() < hole.box.upper.z() && meet(punch, hole.box, 0))
      return punch_text(standing, k, hole);
  }
  return "";
}

/// A space that the tools close from below but not at the side.
std::string open_at_side(const Standing& standing) {
  std::vector<const geometry::Mesh*> solids;
  for (const auto& mesh : standing.meshes) solids.push_back(&mesh);
  const auto opening = geometry::find_side_opening(solids, standing.tooling.fill_plane);
  if (!opening) return "";
  return results::formatted(
      "the space that the tools close from below is open at the side near x = %.4g mm, y = %.4g mm, from z = "
      "%.4g mm up, below the fill plane at z = %.4g mm: powder would flow out there; close it in CAD, or add "
      "the tool that closes it",
      1e3 * opening->place.x(), 1e3 * opening->place.y(), 1e3 * opening->height,
      1e3 * standing.tooling.fill_plane);
}

std::string nothing_below(const Standing& standing) {
  const geometry::Cavity hole = hole_in_die(standing);
  if (!hole.found) return "";
  for (std::size_t k = 0; k < standing.tools.size(); ++k)
    if (standing.tooling.tools[standing.tools[k]].spec.role == ToolRole::punch)
      return punch_text(standing, k, hole);
  char text[240];
  std::snprintf(text, sizeof text,
                "nothing closes the die from below: it has a through hole of %.4g x %.4g mm, and no tool is "
                "a punch; add a [[tool]] with role = \"punch\" whose top is the cavity floor",
                1e3 * hole.box.size().x(), 1e3 * hole.box.size().y());
  return text;
}

}  // namespace

std::string wrong_unit(const Scene& scene, const Tooling& tooling) {
  return wrong_unit(standing_of(scene, tooling, std::vector<ToolPose>(tooling.tools.size())));
}

std::string why_no_cavity(const Scene& scene, const Tooling& tooling, const std::vector<ToolPose>& poses) {
  const Standing standing = standing_of(scene, tooling, poses);
  using Reason = std::string (*)(const Standing&);
  for (const Reason reason :
       {Reason(wrong_fill_plane), Reason(wrong_unit), Reason(lifted_out), Reason(filled_by_punch),
        Reason(open_at_side), Reason(turned), Reason(nothing_below)}) {
    const std::string words = reason(standing);
    if (!words.empty()) return words;
  }
  const geometry::Box die = standing.meshes[standing.die].bounding_box();
  return "die \"" + tooling.tools[tooling.die].spec.name + "\" is at " + in_z(die) +
         ": the tools have no hole or pocket that is open at the fill plane (z = " +
         results::formatted("%.4g", 1e3 * tooling.fill_plane) +
         " mm), and closed below and at all sides; check the CAD model, in which z points up";
}

}  // namespace diefill::process
