#include "process/tooling/examination/shoe_floor.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "process/results/formatted.h"
#include "process/tooling/examination/plan_view.h"
#include "process/tooling/stages.h"

namespace diefill::process {

namespace {

constexpr int kCells = 100;          // each way, of the shoe seen from above
constexpr double kFewOpen = 2e-3;    // of the places: lines along edges of triangles may miss a floor
constexpr double kTipped = 0.9;      // cosine of the angle from which on a shoe is poured out
constexpr int kDense = 60;           // instants of a step
constexpr double kNothing = -1e300;  // m, no floor

/// The cells of a shoe seen from above.
struct Raster {
  Eigen::Vector2d origin, cell;

  explicit Raster(const geometry::Box& box)
      : origin(box.lower.head<2>()), cell((box.size().head<2>() / kCells).cwiseMax(1e-9)) {}
  /// m, a little off the middle, which may lie on an edge of a symmetric tool.
  Eigen::Vector2d place(int i, int j) const {
    return origin + cell.cwiseProduct(Eigen::Vector2d(i + 0.4871, j + 0.5137));
  }
  static std::size_t index(int i, int j) {
    return static_cast<std::size_t>(j) * kCells + static_cast<std::size_t>(i);
  }
};

/// m, z at which the vertical line through `at` meets the triangle; nothing: it passes by.
std::optional<double> height_on(const std::array<Eigen::Vector3d, 3>& corner, const Eigen::Vector2d& at) {
  const Eigen::Vector2d a = corner[0].head<2>() - at, b = corner[1].head<2>() - at,
                        c = corner[2].head<2>() - at;
  const auto cross = [](const Eigen::Vector2d& p, const Eigen::Vector2d& q) {
    return p.x() * q.y() - p.y() * q.x();
  };
  const double of_a = cross(b, c), of_b = cross(c, a), of_c = cross(a, b), all = of_a + of_b + of_c;
  if (all == 0 || of_a * all < 0 || of_b * all < 0 || of_c * all < 0) return std::nullopt;
  return (of_a * corner[0].z() + of_b * corner[1].z() + of_c * corner[2].z()) / all;
}

/// m, of every cell the highest surface of the shoe below `height`.
std::vector<double> floors_below(const geometry::Mesh& mesh, const Raster& raster, double height) {
  std::vector<double> floors(static_cast<std::size_t>(kCells) * kCells, kNothing);
  for (const auto& triangle : mesh.triangles) {
    std::array<Eigen::Vector3d, 3> corner;
    geometry::Box box;
    for (std::size_t k = 0; k < 3; ++k) {
      corner[k] = mesh.vertices[static_cast<std::size_t>(triangle[static_cast<int>(k)])];
      box.include(corner[k]);
    }
    if (box.lower.z() >= height) continue;
    const Eigen::Array2d from = (box.lower.head<2>() - raster.origin).array() / raster.cell.array(),
                         to = (box.upper.head<2>() - raster.origin).array() / raster.cell.array();
    const auto cell = [](double at) { return std::clamp(static_cast<int>(std::floor(at)), 0, kCells - 1); };
    for (int j = cell(from.y()); j <= cell(to.y()); ++j)
      for (int i = cell(from.x()); i <= cell(to.x()); ++i) {
        const auto z = height_on(corner, raster.place(i, j));
        double& floor = floors[Raster::index(i, j)];
        if (z && *z < height) floor = std::max(floor, *z);
      }
  }
  return floors;
}

/// m, z in the middle of the powder in the shoe, or of the shoe where that is not known.
double middle_of_powder(const PourSpec& pour, const geometry::Box& shoe) {
  const double depth = std::min(pour.upper.z() - pour.lower.z(), std::max(pour.fill_height, 0.0));
  const double middle = pour.lower.z() + 0.5 * depth;
  const bool inside = depth > 0 && middle > shoe.lower.z() && middle < shoe.upper.z();
  return inside ? middle : 0.5 * (shoe.lower.z() + shoe.upper.z());
}

bool in_pour_box(const PourSpec& pour, const Eigen::Vector2d& place) {
  return (place.array() > pour.lower.head<2>().array()).all() &&
         (place.array() < pour.upper.head<2>().array()).all();
}

bool is_tipped(const Scene& scene, const std::string& shoe) {
  const Stages stages(scene);
  const auto states = predicted(stages, kSettlingGuess);
  const auto times = instants(stages, states, kDense);
  return std::any_of(times.begin(), times.end(), [&](double time) {
    return pose_of(stages, states, shoe, time).rotation(2, 2) < kTipped;
  });
}

}  // namespace

std::optional<ShoeFloor> closed_floor(const Scene& scene, const Tool& shoe) {
  const geometry::Box box = shoe.mesh.bounding_box();
  if (shoe.mesh.triangles.empty() || !(box.size().minCoeff() > 0)) return std::nullopt;
  const double height = middle_of_powder(scene.pour, box);
  const PlanView view(shoe.mesh, height);
  const Raster raster(box);
  const auto floors = floors_below(shoe.mesh, raster, height);
  ShoeFloor floor{std::numeric_limits<double>::infinity(), {}};
  std::size_t powder = 0;
  for (int j = 0; j < kCells; ++j)
    for (int i = 0; i < kCells; ++i) {
      const Eigen::Vector2d place = raster.place(i, j);
      if (!view.holds(place) && !(in_pour_box(scene.pour, place) && !view.solid(place))) continue;
      ++powder;
      const double z = floors[Raster::index(i, j)];
      if (z == kNothing) continue;
      floor.height = std::min(floor.height, z);
      floor.places.emplace_back(place.x(), place.y(), z);
    }
  if (static_cast<double>(powder - floor.places.size()) > kFewOpen * static_cast<double>(powder) ||
      floor.places.empty() || is_tipped(scene, shoe.spec.name))
    return std::nullopt;
  return floor;
}

std::string closed_floor_text(const Tool& shoe, const ShoeFloor& floor) {
  return "shoe \"" + shoe.spec.name +
         results::formatted(
             "\" is closed below all of its powder, z = %.4g mm: nothing can run out of it; "
             "open its bottom, as a frame without floor",
             1e3 * floor.height);
}

}  // namespace diefill::process
