#include "process/measure/fields/box_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "process/measure/cavity_position.h"
#include "process/measure/fields/gaussian_field.h"
#include "process/measure/fields/powder_places.h"
#include "process/measure/tool_solids.h"
#include "process/results/none.h"
#include "process/results/places_without_value.h"

namespace diefill::process {
namespace {

constexpr double kMillimetre = 1e-3;
constexpr double kMaxNodes = 120;  // along the longer side

/// The two axes that a map runs along and the one that it averages over.
struct Axes {
  int first, second, along;
};

Axes axes_of(BoxView view, const results::CavityState& cavity) {
  if (view == BoxView::kPlan) return {0, 1, 2};
  const bool travels_in_x = std::abs(cavity.azimuth_zero.x()) >= std::abs(cavity.azimuth_zero.y());
  return travels_in_x ? Axes{0, 2, 1} : Axes{1, 2, 0};
}

void check(const results::CavityState& cavity) {
  if (!((cavity.upper_corner - cavity.lower_corner).array() > 0).all())
    throw std::invalid_argument("a cavity map needs a cavity, but the tools enclose none");
}

/// Even nodes from end to end, m, about `step` apart.
std::vector<double> nodes(double lower, double upper, double step) {
  const int intervals = std::max(2, static_cast<int>(std::ceil((upper - lower) / step)));
  std::vector<double> places;
  for (int n = 0; n <= intervals; ++n) places.push_back(lower + n * (upper - lower) / intervals);
  return places;
}

/// Midpoints of equal slices about sigma thick, m.
std::vector<double> slices(double lower, double upper, double averaging_width) {
  const int count = std::clamp(static_cast<int>(std::ceil((upper - lower) / averaging_width)), 3, 16);
  std::vector<double> middle;
  for (int n = 0; n < count; ++n) middle.push_back(lower + (n + 0.5) / count * (upper - lower));
  return middle;
}

/// A field without values over two axes of the cavity's box.
results::Field2D empty_map(const results::CavityState& cavity, const Axes& axes, double step,
                           double averaging_width) {
  static const std::array<const char*, 3> names = {"x", "y", "height"};
  const auto name = [&](int axis) { return names[static_cast<std::size_t>(axis)]; };
  const Eigen::Vector3d &lower = cavity.lower_corner, &upper = cavity.upper_corner;
  const double longer =
      std::max(upper[axes.first] - lower[axes.first], upper[axes.second] - lower[axes.second]);
  const double apart = std::max(step, longer / kMaxNodes);
  const auto in_mm = [&](int axis) {
    std::vector<double> places = nodes(lower[axis], upper[axis], apart);
    for (double& place : places) place = (place - (axis == 2 ? lower.z() : 0)) / kMillimetre;
    return places;
  };
  return {"solid fraction",  name(axes.first),   "mm", name(axes.second), "mm",
          in_mm(axes.first), in_mm(axes.second), {},   averaging_width};
}

/// Place (m) of a map's coordinates (mm) at `depth` along the third axis.
Eigen::Vector3d point_of(const results::CavityState& cavity, const Axes& axes, double first, double second,
                         double depth) {
  Eigen::Vector3d point;
  point[axes.first] = kMillimetre * first;
  point[axes.second] = kMillimetre * second + (axes.second == 2 ? cavity.lower_corner.z() : 0);
  point[axes.along] = depth;
  return point;
}

/// Inside a tool by more than half the distance of nodes: fields reach as far into walls as pictures need.
bool inside_a_tool(const std::vector<geometry::SolidQuery>& solids, const Eigen::Vector3d& point,
                   double skin) {
  return std::ranges::any_of(solids, [&](const auto& solid) { return solid.signed_distance(point) < -skin; });
}

/// Nodes from `first` to before `end` that are within `reach` of `place` along an axis.
struct NodeSpan {
  std::size_t first, end;
};
NodeSpan span_of(const std::vector<double>& axis, double place, double reach) {
  const auto first = std::lower_bound(axis.begin(), axis.end(), place - reach);
  const auto end = std::upper_bound(axis.begin(), axis.end(), place + reach);
  return {static_cast<std::size_t>(first - axis.begin()), static_cast<std::size_t>(end - axis.begin())};
}

/// Lifts the level of the nodes within `reach` of `centre` to `top`; all in mm.
void raise(results::Field2D& map, const Eigen::Vector3d& centre, double reach, double top) {
  const NodeSpan columns = span_of(map.first, centre.x(), reach),
                 rows = span_of(map.second, centre.y(), reach);
  for (std::size_t j = rows.first; j < rows.end; ++j)
    for (std::size_t i = columns.first; i < columns.end; ++i) {
      if (std::hypot(map.first[i] - centre.x(), map.second[j] - centre.y()) > reach) continue;
      double& level = map.value[j * map.first.size() + i];
      if (!(level >= top)) level = top;  // also where there was none (NaN)
    }
}

/// Whether `point` and all places within about `skin` (m) of it in the map's plane are inside tools. The
/// distance to the surface alone would not tell: close below the tools' upper faces it is small everywhere.
bool deep_in_tools(const std::vector<geometry::SolidQuery>& solids, const Eigen::Vector3d& point,
                   const Axes& axes, double skin) {
  if (inside_a_tool(solids, point, skin)) return true;
  if (!inside_a_tool(solids, point, 0)) return false;
  constexpr int kDirections = 8;
  for (int n = 0; n < kDirections; ++n) {
    const double angle = 2 * std::numbers::pi * n / kDirections;
    Eigen::Vector3d beside = point;
    beside[axes.first] += skin * std::cos(angle);
    beside[axes.second] += skin * std::sin(angle);
    if (!inside_a_tool(solids, beside, 0)) return false;
  }
  return true;
}

/// What the columns of a cavity's box hold.
struct BoxColumns {
  GaussianField field;
  const PowderPlaces& places;
  std::vector<geometry::SolidQuery> solids;
  Axes axes;
  double skin;                 ///< m
  std::vector<double> depths;  ///< m, along the column

  /// Mean over the points of a column that hold powder and no tool; `is_near`: whether there is powder.
  template <class PointAt>
  double mean(const PointAt& point_at, bool& is_near) const {
    double sum = 0;
    std::size_t values = 0;
    for (const double depth : depths) {
      const Eigen::Vector3d point = point_at(depth);
      if (!places.near(point) || deep_in_tools(solids, point, axes, skin)) continue;
      is_near = true;
      const double value = field.mean_at(point);
      if (std::isnan(value)) continue;
      sum += value;
      ++values;
    }
    if (values > 0) return sum / static_cast<double>(values);
    if (is_near) return results::unvalued_powder();
    const bool tool = std::ranges::all_of(
        depths, [&](double depth) { return deep_in_tools(solids, point_at(depth), axes, skin); });
    return tool ? results::inside_tool() : kNone;
  }
};

}  // namespace

results::Field2D box_map(const results::FillResult& result, BoxView view, double averaging_width) {
  const auto& cavity = result.cavity;
  check(cavity);
  const Axes axes = axes_of(view, cavity);
  const PowderPlaces places(result.powder);
  results::Field2D map = empty_map(cavity, axes, 0.5 * averaging_width, averaging_width);
  const double first_step = kMillimetre * (map.first[1] - map.first[0]),
               second_step = kMillimetre * (map.second[1] - map.second[0]);
  BoxColumns columns{
      GaussianField(result.powder, result.solid_fraction, averaging_width),
      places,
      solids_of(result.tools),
      axes,
      std::max(first_step, second_step),
      slices(cavity.lower_corner[axes.along], cavity.upper_corner[axes.along], averaging_width)};
  std::vector<std::uint8_t> near;
  for (const double second : map.second)
    for (const double first : map.first) {
      bool is_near = false;
      map.value.push_back(
          columns.mean([&](double depth) { return point_of(cavity, axes, first, second, depth); }, is_near));
      near.push_back(is_near ? 1 : 0);
    }
  const auto is_tool = [&](std::size_t i, std::size_t j) {
    return results::is_inside_tool(map.value[j * map.first.size() + i]);
  };
  erode_edges(near, {map.first.size(), map.second.size(), first_step, second_step, false},
              outline_depth(places), is_tool);
  for (std::size_t n = 0; n < near.size(); ++n)
    if (near[n] == 0 && !results::is_inside_tool(map.value[n])) map.value[n] = kNone;
  return map;
}

results::Field2D fill_level_map(const results::FillResult& result) {
  const auto& cavity = result.cavity;
  check(cavity);
  const auto& powder = result.powder;
  const Axes axes{0, 1, 2};
  results::Field2D map = empty_map(cavity, axes, 0.25 * powder.grain_diameter, 0);
  map.quantity = std::string("fill level");
  map.value.assign(map.first.size() * map.second.size(), kNone);
  const auto centres = powder.sphere_centres();
  const auto radii = powder.radii_of_spheres();
  const auto grains = powder.grains_of_spheres();
  for (std::size_t n = 0; n < centres.size(); ++n) {
    const std::size_t grain = grains[n];
    if (!lies_in_cavity(cavity, powder.position[grain])) continue;
    const double top = centres[n].z() + radii[n] - cavity.lower_corner.z();
    raise(map, centres[n] / kMillimetre, powder.diameter_of(grain) / kMillimetre, top / kMillimetre);
  }
  const auto solids = solids_of(result.tools);
  const double skin = kMillimetre * (map.first[1] - map.first[0]);
  const double middle = 0.5 * (cavity.lower_corner.z() + cavity.upper_corner.z());
  for (std::size_t n = 0; n < map.value.size(); ++n) {
    const std::size_t columns = map.first.size();
    const Eigen::Vector3d place =
        point_of(cavity, axes, map.first[n % columns], map.second[n / columns], middle);
    if (inside_a_tool(solids, place, skin)) map.value[n] = results::inside_tool();
  }
  return map;
}

results::Profile fill_level_along_travel(const results::Field2D& level, const results::CavityState& cavity) {
  const bool over_first = axes_of(BoxView::kSide, cavity).first == 0;
  const std::vector<double>&along = over_first ? level.first : level.second,
        &across = over_first ? level.second : level.first;
  results::Profile profile{"fill level", "mm", "distance along the shoe's travel", "mm", {}, {}};
  for (std::size_t n = 0; n < along.size(); ++n) {
    double sum = 0, count = 0;
    bool powder = false;
    for (std::size_t m = 0; m < across.size(); ++m) {
      const double here = level.value[over_first ? m * along.size() + n : n * across.size() + m];
      if (results::is_inside_tool(here)) continue;
      powder = powder || !std::isnan(here);
      sum += std::isnan(here) ? 0 : here;  // no powder here: the floor
      ++count;
    }
    profile.x.push_back(along[n] - along.front());
    profile.y.push_back(powder ? sum / count : kNone);
  }
  // The shoe arrives at the end towards which azimuth zero points.
  if (cavity.azimuth_zero[over_first ? 0 : 1] > 0) std::reverse(profile.y.begin(), profile.y.end());
  return profile;
}

results::Profile fill_level_along_travel(const results::FillResult& result) {
  return fill_level_along_travel(fill_level_map(result), result.cavity);
}

}  // namespace diefill::process
