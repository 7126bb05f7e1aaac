#include "geometry/mesh/mesh_repair.h"

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/repair_degeneracies.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "geometry/mesh/cgal_mesh.h"
#include "geometry/mesh/mesh_stitch.h"
#include "geometry/mesh/mesh_wrap.h"

namespace diefill::geometry {

namespace {

namespace processing = CGAL::Polygon_mesh_processing;
using cgal::Point;
using cgal::Surface;

constexpr double kFinestWrap = 1.0 / 400;  // of the diagonal; finer wraps take minutes and gigabytes

std::string counted(std::size_t count, const std::string& one, const std::string& many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

template <class... Values>
std::string formatted(const char* format, Values... values) {
  char text[240];
  std::snprintf(text, sizeof text, format, values...);
  return text;
}

/// Triangles that close a hole, as indices into its rim.
using Patch = std::vector<CGAL::Triple<int, int, int>>;

/// The rim in loops that pass no place twice: holes that touch at a corner have one rim round them all.
std::vector<std::vector<Point>> simple_loops(const std::vector<Point>& rim) {
  std::vector<std::vector<Point>> loops;
  std::vector<Point> open;
  for (const Point& place : rim) {
    const auto before = std::find(open.begin(), open.end(), place);
    if (before != open.end()) {
      loops.emplace_back(before, open.end());
      open.erase(before, open.end());
    }
    open.push_back(place);
  }
  loops.push_back(open);
  return loops;
}

/// One repair, step by step.
class Repair {
 public:
  Repair(const Mesh& mesh, const MeshFindings& findings, const RepairOptions& options)
      : mesh_(mesh), findings_(findings), options_(options) {
    diagonal_ = mesh.bounding_box().size().norm();
  }
  RepairedMesh run();

 private:
  bool stitch();
  void close_edges();
  void drop_inner_walls();
  bool stitch_shells();
  void drop_copies(cgal::Soup& soup);
  void fill_holes();
  void fill(Surface::Halfedge_index border);
  Patch patch_for(const std::vector<Point>& rim);
  void join_patches();
  void turn_outward();
  void unite_shells();
  void drop_slivers();
  void wrap(RepairedMesh& result);
  void record(const std::string& repair) { repairs_.push_back(repair); }

  Mesh mesh_;
  const MeshFindings& findings_;
  const RepairOptions& options_;
  double diagonal_ = 0;
  Surface surface_;
  std::vector<std::array<Point, 3>> patches_;  ///< of holes that touch, not yet in the surface
  std::vector<std::string> repairs_, refused_;
};

/// Only corners at open edges are loose; others may be close together on purpose.
void Repair::close_edges() {
  if (check_mesh(mesh_).open_edges == 0) return;
  const double tolerance = options_.weld * diagonal_;
  const WeldedCorners welded = weld_loose_corners(mesh_, tolerance);
  if (welded.count > 0)
    record(counted(welded.count, "corner", "corners") +
           formatted(" welded to a neighbour at most %.2g mm away", 1e3 * welded.farthest));
  const std::size_t split = split_edges_at_corners(mesh_, tolerance);
  if (split > 0)
    record(counted(split, "edge", "edges") + " split where a corner of a neighbour lies on " +
           (split == 1 ? "it" : "them"));
}

/// Solids that share a face have it twice, facing both ways: no boundary of what they are together.
void Repair::drop_inner_walls() {
  const std::size_t dropped = drop_opposite_pairs(mesh_);
  if (dropped > 0)
    record(counted(dropped, "pair", "pairs") + " of triangles between solids that share a face removed");
}

void Repair::drop_copies(cgal::Soup& soup) {
  processing::repair_polygon_soup(soup.points, soup.triangles);
  if (findings_.duplicate_triangles > 0)
    record(counted(findings_.duplicate_triangles, "duplicate triangle", "duplicate triangles") + " removed");
}

/// The triangles as one surface whose neighbours agree about outside. False where sheets meet so that no
/// surface can be made of them.
bool Repair::stitch() {
  const std::size_t slivers = drop_triangles_without_area(mesh_);
  if (slivers > 0) record(counted(slivers, "triangle", "triangles") + " without area removed");
  if (findings_.non_manifold_edges > 0) drop_inner_walls();
  close_edges();
  const bool sheets_meet = check_mesh(mesh_).non_manifold_edges > 0;
  if (sheets_meet && mesh_.volume() < 0) {
    for (auto& triangle : mesh_.triangles) std::swap(triangle[1], triangle[2]);
    record("surface normals reversed to point outward");
  }
  if (sheets_meet && stitch_shells()) return true;
  cgal::Soup soup = cgal::soup_of(mesh_);
  drop_copies(soup);
  if (soup.triangles.empty()) return false;
  if (!processing::orient_polygon_soup(soup.points, soup.triangles) && sheets_meet) {
    refused_.push_back(
        "edges with more than two triangles: ambiguous which bound the solid, repair it in CAD");
    return false;
  }
  if (findings_.badly_oriented_edges > 0) record("triangles flipped so that neighbours agree on the outside");
  if (!processing::is_polygon_soup_a_polygon_mesh(soup.triangles)) return false;
  processing::polygon_soup_to_polygon_mesh(soup.points, soup.triangles, surface_);
  return true;
}

/// Closed solids that touch each other, united. False where they are none.
bool Repair::stitch_shells() {
  std::vector<Surface> solids;
  for (const Mesh& shell : shells_of_solids(mesh_)) {
    cgal::Soup soup = cgal::soup_of(shell);
    processing::repair_polygon_soup(soup.points, soup.triangles);
    if (!processing::orient_polygon_soup(soup.points, soup.triangles)) return false;
    if (!processing::is_polygon_soup_a_polygon_mesh(soup.triangles)) return false;
    solids.emplace_back();
    processing::polygon_soup_to_polygon_mesh(soup.points, soup.triangles, solids.back());
    if (!CGAL::is_closed(solids.back()) || processing::volume(solids.back()) <= 0) return false;
  }
  if (solids.size() < 2) return false;
  Surface united = solids.front();
  for (std::size_t k = 1; k < solids.size(); ++k) {
    Surface next;
    if (!processing::corefine_and_compute_union(united, solids[k], next)) return false;
    united = next;
  }
  surface_ = united;
  record(std::to_string(solids.size()) + " solids that touch united");
  return true;
}

/// Empty, with the reason kept, where the hole may be an opening.
Patch Repair::patch_for(const std::vector<Point>& rim) {
  Patch patch;
  processing::triangulate_hole_polyline(rim, std::back_inserter(patch));
  double area = 0;
  const auto corner = [&](int k) { return rim[static_cast<std::size_t>(k)]; };
  for (const auto& triangle : patch)
    area += std::sqrt(
        CGAL::squared_area(corner(triangle.first), corner(triangle.second), corner(triangle.third)));
  const double most = options_.largest_hole * processing::area(surface_);
  const std::string where =
      formatted("near (%.3f, %.3f, %.3f) mm", 1e3 * rim[0].x(), 1e3 * rim[0].y(), 1e3 * rim[0].z());
  if (patch.empty() || area > most) {
    refused_.push_back(
        formatted("a hole of %.4g mm2, more than %.2g of the surface, ", 1e6 * area, options_.largest_hole) +
        where + " may be an opening");
    return {};
  }
  record(formatted("a hole of %.3g mm2 filled ", 1e6 * area) + where);
  return patch;
}

void Repair::fill(Surface::Halfedge_index border) {
  std::vector<Point> rim;
  for (const auto edge : CGAL::halfedges_around_face(border, surface_))
    rim.push_back(surface_.point(surface_.target(edge)));
  const std::vector<std::vector<Point>> loops = simple_loops(rim);
  if (loops.size() == 1) {
    std::vector<Surface::Face_index> faces;
    if (!patch_for(rim).empty()) processing::triangulate_hole(surface_, border, std::back_inserter(faces));
    return;
  }
  for (const std::vector<Point>& loop : loops) {
    if (loop.size() < 3) continue;  // a slit: its sides meet where corners are merged
    const auto corner = [&](int k) { return loop[static_cast<std::size_t>(k)]; };
    for (const auto& triangle : patch_for(loop))
      patches_.push_back({corner(triangle.first), corner(triangle.second), corner(triangle.third)});
  }
}

/// Where holes touch, the surface has a corner for each of its sides: they become one again.
void Repair::join_patches() {
  cgal::Soup soup = cgal::soup_of(cgal::mesh_of(surface_));
  for (const auto& triangle : patches_) {
    const std::size_t first = soup.points.size();
    soup.points.insert(soup.points.end(), triangle.begin(), triangle.end());
    soup.triangles.push_back({first, first + 1, first + 2});
  }
  processing::repair_polygon_soup(soup.points, soup.triangles);
  processing::orient_polygon_soup(soup.points, soup.triangles);
  if (!processing::is_polygon_soup_a_polygon_mesh(soup.triangles)) return;
  surface_.clear();
  processing::polygon_soup_to_polygon_mesh(soup.points, soup.triangles, surface_);
}

void Repair::fill_holes() {
  std::vector<Surface::Halfedge_index> borders;
  processing::extract_boundary_cycles(surface_, std::back_inserter(borders));
  for (const auto border : borders) fill(border);
  if (!patches_.empty()) join_patches();
}

/// A shell that is inside out is reversed; one that lies inside another becomes the wall of a closed cavity
/// that powder never reaches.
void Repair::turn_outward() {
  const Mesh before = cgal::mesh_of(surface_);
  const MeshFindings findings = check_mesh(before);
  if (findings.inward_shells == 0 || findings.self_intersections > 0) return;
  if (findings.inward_shells == findings.shells && findings.volume < 0) {
    processing::reverse_face_orientations(surface_);
    record("surface normals reversed to point outward");
    return turn_outward();  // a shell inside another may be left
  }
  processing::orient_to_bound_a_volume(surface_);
  record(counted(findings.inward_shells, "shell", "shells") +
         " reversed, so that outer shells face outward and inner shells bound cavities");
}

void Repair::unite_shells() {
  const MeshFindings findings = check_mesh(cgal::mesh_of(surface_));
  if (findings.self_intersections == 0) return;
  std::vector<Surface> shells;
  processing::split_connected_components(surface_, shells);
  for (Surface& shell : shells) {
    if (processing::does_self_intersect(shell)) {
      refused_.push_back("a surface that intersects itself: ambiguous which side is solid, repair it in CAD");
      return;
    }
    if (processing::volume(shell) < 0) processing::reverse_face_orientations(shell);
  }
  Surface united = shells.front();
  for (std::size_t k = 1; k < shells.size(); ++k) {
    Surface next;
    if (!processing::corefine_and_compute_union(united, shells[k], next)) {
      refused_.push_back("shells that touch along an edge cannot be united");
      return;
    }
    united = next;
  }
  surface_ = united;
  record(std::to_string(shells.size()) + " shells that overlap united");
}

void Repair::drop_slivers() {
  const std::size_t before = surface_.number_of_faces();
  processing::remove_degenerate_faces(surface_);
  const std::size_t after = surface_.number_of_faces();
  if (after < before) record(counted(before - after, "sliver", "slivers") + " removed");
}

void Repair::wrap(RepairedMesh& result) {
  const double detail =
      std::max(options_.wrap_detail > 0 ? options_.wrap_detail : diagonal_ / 100, kFinestWrap * diagonal_);
  Mesh mesh = wrapped(mesh_, detail);
  const MeshFindings findings = check_mesh(mesh);
  if (!findings.usable()) return;
  result.largest_deviation = largest_distance(mesh_, mesh);
  result.repairs = {
      formatted("a new surface wrapped round the old one, following features of %.3g mm; largest "
                "deviation %.3g mm; narrower openings are closed and edges rounded",
                1e3 * detail, 1e3 * result.largest_deviation)};
  result.refused.clear();
  result.findings = findings;
  result.mesh = std::move(mesh);
}

RepairedMesh Repair::run() {
  RepairedMesh result{mesh_, findings_, {}, {}, 0};  // as it was
  try {
    if (stitch()) {
      fill_holes();
      turn_outward();
      unite_shells();
      if (findings_.degenerate_triangles > 0) drop_slivers();  // that uniting made
      Mesh repaired = cgal::mesh_of(surface_);
      const MeshFindings findings = check_mesh(repaired);
      if (findings.usable()) return {std::move(repaired), findings, repairs_, refused_, 0};
      if (refused_.empty())
        refused_.push_back("repairs that need no guess leave " + findings.description().front());
    }
    result.refused = refused_;
    if (options_.level == RepairLevel::kWrap) wrap(result);
  } catch (const std::exception&) {
    result.refused.push_back("CGAL could not repair it");
  }
  return result;
}

}  // namespace

namespace {

/// Copies do no harm to the check, which leaves them out, but copies facing both ways hide the solid from
/// other shells.
RepairedMesh without_copies(const Mesh& mesh) {
  RepairedMesh result{mesh, {}, {}, {}, 0};
  const std::size_t dropped = drop_copies_of_triangles(result.mesh);
  result.findings = check_mesh(result.mesh);
  result.repairs.push_back(counted(dropped, "duplicate triangle", "duplicate triangles") + " removed");
  return result;
}

}  // namespace

RepairedMesh repair_mesh(const Mesh& mesh, const MeshFindings& findings, const RepairOptions& options) {
  const bool hopeless = findings.not_finite > 0 || findings.triangles == 0;
  const bool nothing_to_do = findings.usable() && findings.duplicate_triangles == 0;
  if (options.level == RepairLevel::kOff || hopeless || nothing_to_do) return {mesh, findings, {}, {}, 0};
  if (findings.usable()) return without_copies(mesh);
  return Repair(mesh, findings, options).run();
}

}  // namespace diefill::geometry
