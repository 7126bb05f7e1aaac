#include "geometry/cad/mesh_import.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <iomanip>
#include <limits>
#include <sstream>

#include "geometry/cad/cad_child.h"
#include "geometry/cad/cad_file.h"
#include "geometry/cad/cad_parts.h"
#include "geometry/cad/cad_readers.h"
#include "geometry/cad/read_binary_stl.h"
#include "geometry/cad/read_text_stl.h"
#include "geometry/cad/referred_files.h"
#include "geometry/cad/shown_text.h"
#include "geometry/cad/wanted_part.h"
#include "geometry/grids/distinct_points.h"
#include "geometry/grids/point_grid.h"

namespace diefill::geometry {

namespace {

/// Vertices closer than this part of the bounding box's diagonal are one: CAD files carry single precision,
/// whose steps are 6e-8 of a coordinate, so that copies of one corner can differ by about as much.
constexpr double kJoinTolerance = 1e-7;
constexpr double kRemarkedStep = 1e-5;  // of the diagonal: rounding that repairs may have to bridge
constexpr double kRefusedStep = 3e-4;   // of the diagonal: some hundredths of a millimetre on a tool
constexpr std::size_t kLongestReason = 300;
constexpr double kMillimetre = 1e-3;  // m
constexpr double kSameUnit = 1e-3;    // units of length differ by more

/// Numbers the vertices that `place_of(vertex)` names by the triangles' first use of them; those without
/// triangles go.
template <typename PlaceOf>
void number_vertices(Mesh& mesh, PlaceOf place_of) {
  std::vector<int> number(mesh.vertices.size(), -1);
  for (Eigen::Vector3i& triangle : mesh.triangles)
    for (int& corner : triangle) {
      int& own = number[static_cast<std::size_t>(corner)];
      if (own < 0) own = place_of(mesh.vertices[static_cast<std::size_t>(corner)]);
      corner = own;
    }
}

/// Vertices within tolerance of an earlier one become that one; vertices without triangles go.
void join_vertices(Mesh& mesh) {
  const double tolerance = kJoinTolerance * mesh.bounding_box().size().norm();
  if (surely_distinct(mesh.vertices, tolerance)) {
    std::vector<Eigen::Vector3d> kept;
    kept.reserve(mesh.vertices.size());
    number_vertices(mesh, [&](const Eigen::Vector3d& vertex) {
      kept.push_back(vertex);
      return static_cast<int>(kept.size() - 1);
    });
    mesh.vertices = std::move(kept);
    return;
  }
  PointGrid kept(16 * tolerance);  // most questions then look into one cell
  kept.reserve(mesh.vertices.size());
  number_vertices(mesh, [&](const Eigen::Vector3d& vertex) {
    const std::size_t same = kept.nearest_within(vertex, tolerance);
    return static_cast<int>(same == PointGrid::kNone ? kept.insert(vertex) : same);
  });
  mesh.vertices = kept.points();
}

void check_corners(const Mesh& mesh, const std::filesystem::path& file) {
  const auto bad = std::find_if(mesh.vertices.begin(), mesh.vertices.end(),
                                [](const Eigen::Vector3d& v) { return !v.allFinite(); });
  if (bad != mesh.vertices.end())
    throw MeshError(named(file) + " has a corner with a non-finite coordinate (corner " +
                    std::to_string(bad - mesh.vertices.begin() + 1) + "): export it again");
  const auto count = static_cast<int>(mesh.vertices.size());
  for (const Eigen::Vector3i& triangle : mesh.triangles)
    if (triangle.minCoeff() < 0 || triangle.maxCoeff() >= count)
      throw MeshError(named(file) + " has a triangle with a corner that does not exist: export it again");
}

std::string unit_text(double metres) {
  for (const auto& [name, size] :
       {std::pair{"mm", 1e-3}, {"um", 1e-6}, {"cm", 1e-2}, {"m", 1.0}, {"inch", 0.0254}, {"foot", 0.3048}})
    if (std::abs(metres / size - 1) < kSameUnit) return name;
  char text[40];
  std::snprintf(text, sizeof text, "%g mm", 1e3 * metres);
  return text;
}

/// The file's own unit and the one given must agree where there are both.
double unit_of(const std::filesystem::path& file, const CadParts& contents, const ImportOptions& options) {
  const auto& given = options.metres_per_unit;
  const auto& stated = contents.metres_per_unit;
  if (!stated && !given)
    throw MeshError(named(file) + " does not state its unit of length: give length_unit, such as \"mm\"");
  if (stated && given && std::abs(*given / *stated - 1) > kSameUnit)
    throw MeshError(named(file) + " states its unit, " + unit_text(*stated) + ", but " + unit_text(*given) +
                    " is given: remove the unit, or export the file again");
  return stated ? *stated : *given;
}

/// The parts that the name selects as one mesh.
Mesh wanted(const std::string& file, CadParts contents, const std::string& name, double metres_per_unit) {
  Mesh mesh;
  for (const std::size_t k : wanted_parts(contents.parts, name, file, metres_per_unit)) {
    CadPart& part = contents.parts[k];
    if (mesh.triangles.empty()) {
      mesh = std::move(part.mesh);
      continue;
    }
    const int offset = static_cast<int>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), part.mesh.vertices.begin(), part.mesh.vertices.end());
    for (const auto& triangle : part.mesh.triangles) mesh.triangles.emplace_back(triangle.array() + offset);
  }
  return mesh;
}

/// Curved surfaces take the time and memory of the triangles that are made of them, whatever the file's size.
std::string remedy(const CadFormat& format, double chord_tolerance, ChildFailure failure) {
  const bool takes_too_much = failure == ChildFailure::kTooLong || failure == ChildFailure::kTooMuchMemory;
  if (format.surface != SurfaceKind::kCurved || !takes_too_much ||
      chord_tolerance >= ImportOptions{}.chord_tolerance)
    return "; export it again, best as STEP or STL";
  char text[200];
  std::snprintf(
      text, sizeof text,
      "; chord_tolerance is \"%.3g mm\", which may ask for too many triangles: give a larger one, or "
      "remove it (default: %.3g mm)",
      1e3 * chord_tolerance, 1e3 * ImportOptions{}.chord_tolerance);
  return text;
}

CadParts read(const std::filesystem::path& file, const CadFormat& format, double chord_tolerance,
              const std::string& bytes) {
  if (format.ending == "stl" && !is_text_stl(bytes) && is_binary_stl(bytes)) return read_binary_stl(bytes);
  try {
    // Triangles are only copied; a few curved faces can take long to mesh finely.
    const bool curved = format.surface == SurfaceKind::kCurved;
    const unsigned seconds = curved ? 60 : 10;
    if (curved) load_opencascade();
    return read_in_child([&] { return read_cad_parts(file, format, chord_tolerance); },
                         {bytes.size(), seconds});
  } catch (const ChildError& error) {
    throw UnreadableFile(named(file) + " cannot be read as " + format.ending + ": " +
                             shown(error.what(), kLongestReason) +
                             remedy(format, chord_tolerance, error.failure),
                         error.failure);
  }
}

/// Whether coordinates of this kind of file come with seven digits: in single precision.
bool has_single_precision(const CadFormat& format, const std::string& bytes) {
  if (format.surface == SurfaceKind::kCurved) return false;
  return format.ending != "stl" || !is_text_stl(bytes);
}

/// Far from the origin the digits that single precision has do not suffice to tell corners apart. `mesh` in
/// m.
void check_digits(const std::string& file, const Mesh& mesh, std::vector<std::string>& remarks) {
  const Box box = mesh.bounding_box();
  const double farthest = box.lower.cwiseAbs().cwiseMax(box.upper.cwiseAbs()).maxCoeff();
  const double step = farthest * std::numeric_limits<float>::epsilon();
  const double size = box.size().norm();
  if (step < kRemarkedStep * size) return;
  char text[240];
  std::snprintf(text, sizeof text,
                "at %.4g m from the origin single precision rounds corners to steps of about %.2g mm",
                farthest, 1e3 * step);
  if (step > kRefusedStep * size)
    throw MeshError(file + ": " + text +
                    ", which distorts its shape; move it to the origin in CAD and export it again");
  remarks.emplace_back(text);
}

void check_options(const std::filesystem::path& file, const ImportOptions& options) {
  const double unit = options.metres_per_unit.value_or(1);
  if (!(std::isfinite(unit) && unit > 0))
    throw MeshError(named(file) + ": the unit of length must be a positive number of metres, not " +
                    std::to_string(unit));
  if (!(std::isfinite(options.chord_tolerance) && options.chord_tolerance > 0))
    throw MeshError(named(file) + ": the chord tolerance must be a positive number of metres, not " +
                    std::to_string(options.chord_tolerance));
}

}  // namespace

ImportedPart import_part(const std::filesystem::path& file, const ImportOptions& options) {
  check_options(file, options);
  const std::string bytes = read_cad_file(file);
  const CadFormat* format = cad_format(file);
  if (format == nullptr)
    throw MeshError(named(file) + " has an unsupported format '" +
                    shown(file.extension().string().substr(file.has_extension() ? 1 : 0), 40) +
                    "': export it as " + cad_formats_text());
  check_content_matches_format(file, format->ending, bytes);
  CadParts contents = read(file, *format, options.chord_tolerance, bytes);
  const bool curved = format->surface == SurfaceKind::kCurved;
  // Without a unit the tolerance was applied as if the file were in millimetres.
  if (curved && !contents.metres_per_unit && options.metres_per_unit &&
      *options.metres_per_unit != kMillimetre)
    contents = read(file, *format, options.chord_tolerance * kMillimetre / *options.metres_per_unit, bytes);

  ImportedPart result;
  result.unit_from_file = contents.metres_per_unit.has_value();
  result.metres_per_unit = unit_of(file, contents, options);
  result.curved = curved;
  for (const CadPart& part : contents.parts) result.parts.push_back(part.name);
  result.remarks = std::move(contents.remarks);
  result.mesh = wanted(named(file), std::move(contents), options.part, result.metres_per_unit);
  check_corners(result.mesh, file);
  join_vertices(result.mesh);
  for (Eigen::Vector3d& vertex : result.mesh.vertices) vertex *= result.metres_per_unit;
  if (has_single_precision(*format, bytes)) check_digits(named(file), result.mesh, result.remarks);
  return result;
}

Mesh import_mesh(const std::filesystem::path& file, double metres_per_unit) {
  ImportOptions options;
  options.metres_per_unit = metres_per_unit;
  return import_part(file, options).mesh;
}

std::string file_hash(const std::filesystem::path& file) {
  // FNV-1a, 64 bit (Fowler, Noll and Vo; RFC 9923).
  std::uint64_t hash = 0xcbf29ce484222325U;
  const auto add = [&](const std::string& bytes) {
    for (const char byte : bytes) {
      hash ^= static_cast<unsigned char>(byte);
      hash *= 0x100000001b3U;
    }
  };
  add(read_cad_file(file));
  for (const auto& referred : referred_files(file)) {
    add(referred.generic_string());
    add(read_cad_file(file.parent_path() / referred));
  }
  std::ostringstream text;
  text << std::hex << std::setw(16) << std::setfill('0') << hash;
  return text.str();
}

}  // namespace diefill::geometry
