// Sharing a sphere out among cylindrical cells.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "process/measure/volumes/gauss_legendre.h"
#include "process/measure/volumes/grid_shares.h"
#include "process/measure/volumes/sphere_overlap.h"

namespace diefill::process {
namespace {

constexpr double kPi = std::numbers::pi;

/// A sphere in cylindrical coordinates, angles counted from its own azimuth.
struct RoundSphere {
  double distance, radius;
  std::vector<double> radii;    ///< edges of the cells it may reach into, m
  std::vector<double> angles;   ///< rad from the sphere's azimuth
  std::vector<double> heights;  ///< m from the sphere's centre
};

bool is_crossed(const RoundSphere& sphere, double circle_radius) {
  return std::abs(sphere.distance - circle_radius) < sphere.radius;
}

/// Heights above the centre at which the horizontal cut through the sphere changes its shape: where it
/// touches a circle, a ray, one of their crossings, or the axis.
std::vector<double> shape_changes(const RoundSphere& sphere) {
  std::vector<double> cut_radii = {0, sphere.distance};
  for (const double circle : sphere.radii) cut_radii.push_back(std::abs(sphere.distance - circle));
  for (const double angle : sphere.angles) {
    cut_radii.push_back(std::abs(sphere.distance * std::sin(angle)));
    for (const double circle : sphere.radii)
      cut_radii.push_back(std::hypot(circle * std::cos(angle) - sphere.distance, circle * std::sin(angle)));
  }
  std::vector<double> heights = sphere.heights;
  for (const double cut : cut_radii) {
    if (!(cut <= sphere.radius)) continue;
    const double height = std::sqrt((sphere.radius - cut) * (sphere.radius + cut));
    heights.push_back(height);
    heights.push_back(-height);
  }
  for (double& height : heights) height = std::clamp(height, -sphere.radius, sphere.radius);
  std::sort(heights.begin(), heights.end());
  return heights;
}

/// Cells in one layer of the grid: radius fastest, then azimuth.
using Layer = std::vector<double>;

/// Adds `weight` times the areas of a horizontal cut of radius `cut_radius`.
void add_areas(Layer& layer, const RoundSphere& sphere, double cut_radius, double weight) {
  const std::size_t columns = sphere.radii.size() - 1;
  for (std::size_t j = 0; j + 1 < sphere.angles.size(); ++j) {
    const auto within = [&](double circle) {
      return disc_in_sector(sphere.distance, cut_radius, circle, sphere.angles[j], sphere.angles[j + 1]);
    };
    double inner = within(sphere.radii.front());
    for (std::size_t i = 0; i < columns; ++i) {
      const double outer = within(sphere.radii[i + 1]);
      layer[j * columns + i] += weight * (outer - inner);
      inner = outer;
    }
  }
}

/// Integrates the cut's areas over heights lower..upper, between which its shape does not change. Areas set
/// in with powers 3/2 of the height at the ends, which t^2 (3 - 2 t) turns into whole powers.
void integrate(Layer& layer, const RoundSphere& sphere, double lower, double upper) {
  for (const auto& [place, weight] : gauss_legendre()) {
    const double height = lower + (upper - lower) * place * place * (3 - 2 * place);
    const double slope = (upper - lower) * 6 * place * (1 - place);
    const double cut = std::sqrt((sphere.radius - height) * (sphere.radius + height));
    add_areas(layer, sphere, cut, weight * slope);
  }
}

Layer layer_by_integration(const RoundSphere& sphere, const std::vector<double>& changes, double lower,
                           double upper) {
  Layer layer((sphere.radii.size() - 1) * (sphere.angles.size() - 1), 0.0);
  for (std::size_t n = 0; n + 1 < changes.size(); ++n)
    if (changes[n] >= lower && changes[n + 1] <= upper && changes[n + 1] > changes[n])
      integrate(layer, sphere, changes[n], changes[n + 1]);
  return layer;
}

/// Without a circle through the sphere its cells are wedges: planes upright and level.
Layer layer_of_wedges(const RoundSphere& sphere, double lower, double upper) {
  const auto beyond = [&](double angle, double height) {
    const double place = angle <= -0.5 * kPi  ? -1
                         : angle >= 0.5 * kPi ? 1
                                              : sphere.distance * std::sin(angle) / sphere.radius;
    return ball_beyond(std::clamp(place, -1.0, 1.0), height / sphere.radius);
  };
  Layer layer;
  for (std::size_t j = 0; j + 1 < sphere.angles.size(); ++j)
    layer.push_back(std::pow(sphere.radius, 3) *
                    ((beyond(sphere.angles[j], lower) - beyond(sphere.angles[j], upper)) -
                     (beyond(sphere.angles[j + 1], lower) - beyond(sphere.angles[j + 1], upper))));
  return layer;
}

/// Ranges of azimuth cells that the sphere is seen under, each with the turns to add to its edges.
struct AngleRange {
  CellRange cells;
  double turned = 0;
};

std::vector<AngleRange> angle_ranges(const std::vector<double>& edges, double azimuth, double half) {
  std::vector<AngleRange> ranges;
  for (const double turned : {-2 * kPi, 0.0, 2 * kPi}) {
    const CellRange cells = cells_between(edges, azimuth - half - turned, azimuth + half - turned);
    if (!cells.empty) ranges.push_back({cells, turned});
  }
  // A sphere over the axis is seen all round: every cell once, whatever turn finds it.
  if (half >= kPi) return {{{0, edges.size() - 2, false}, 0}};
  return ranges;
}

std::vector<double> edges_of(const std::vector<double>& edges, const CellRange& range, double shift) {
  std::vector<double> shifted;
  for (std::size_t k = range.first; k <= range.last + 1; ++k) shifted.push_back(edges[k] + shift);
  return shifted;
}

}  // namespace

void share_sphere_round(results::CellField& field, double distance, double azimuth, double height,
                        double radius, double weight) {
  const auto& edges = field.edges;
  const CellRange circles = cells_between(edges[0], std::max(0.0, distance - radius), distance + radius);
  const CellRange levels = cells_between(edges[2], height - radius, height + radius);
  if (circles.empty || levels.empty) return;
  const bool holds_axis = distance <= radius;
  const double half = holds_axis ? kPi : std::asin(radius / distance);
  for (const AngleRange& angles : angle_ranges(edges[1], azimuth, half)) {
    RoundSphere sphere{distance, radius, edges_of(edges[0], circles, 0),
                       edges_of(edges[1], angles.cells, angles.turned - azimuth),
                       edges_of(edges[2], levels, -height)};
    for (double& level : sphere.heights) level = std::clamp(level, -radius, radius);
    const bool wedges = !holds_axis && sphere.radii.size() == 2 && !is_crossed(sphere, sphere.radii[0]) &&
                        !is_crossed(sphere, sphere.radii[1]);
    const auto changes = wedges ? std::vector<double>() : shape_changes(sphere);
    for (std::size_t k = 0; k + 1 < sphere.heights.size(); ++k) {
      const double lower = sphere.heights[k], upper = sphere.heights[k + 1];
      const Layer layer = wedges ? layer_of_wedges(sphere, lower, upper)
                                 : layer_by_integration(sphere, changes, lower, upper);
      const std::size_t columns = sphere.radii.size() - 1;
      for (std::size_t n = 0; n < layer.size(); ++n)
        field.value[field.cell(circles.first + n % columns, angles.cells.first + n / columns,
                               levels.first + k)] += weight * std::max(0.0, layer[n]);
    }
  }
}

}  // namespace diefill::process
