#include "geometry/wall_spheres/wall_rows.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <tuple>
#include <unordered_map>

namespace diefill::geometry {

namespace {

/// Edges with a smaller angle between their faces (rad) are part of a smooth surface.
constexpr double kSharpAngle = 0.56;
/// Cosine of the largest turn between edges that a row runs through without a corner.
constexpr double kStraightOn = 0.85;
/// Blunter wedges than this have their row where it is of use (1 + cos of the angle between the normals).
constexpr double kSharpestWedge = 0.02;
constexpr int kBisections = 60;

/// An edge between two facets, once (from the side of the facet with the lower number).
struct SharpEdge {
  const BorderEdge* border;
  Eigen::Vector3d normal, other_normal;
  Eigen::Vector3d along() const { return (border->to() - border->from()).normalized(); }
};

std::vector<SharpEdge> sharp_edges(const Facets& facets) {
  std::vector<SharpEdge> edges;
  for (std::size_t f = 0; f < facets.size(); ++f)
    for (const BorderEdge& border : facets[f].border)
      if (border.other > static_cast<std::int32_t>(f) && border.angle >= kSharpAngle)
        edges.push_back({&border, facets[f].normal, facets[static_cast<std::size_t>(border.other)].normal});
  return edges;
}

/// Edges one after the other, each with its direction of travel.
struct EdgeLine {
  std::vector<std::pair<std::size_t, bool>> edges;  ///< index and whether travelled from `from` to `to`
  bool closed = false;
};

/// Joins edges to lines through vertices where exactly two edges of one kind meet without a corner.
class LineFinder {
 public:
  explicit LineFinder(const std::vector<SharpEdge>& edges) : edges_(edges), taken_(edges.size(), 0) {
    for (std::size_t e = 0; e < edges.size(); ++e) {
      at_vertex_[edges[e].border->from_corner].push_back(e);
      at_vertex_[edges[e].border->to_corner].push_back(e);
    }
  }

  std::vector<EdgeLine> find() {
    std::vector<EdgeLine> lines;
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      if (taken_[e]) continue;
      taken_[e] = 1;
      EdgeLine line;
      line.edges.emplace_back(e, true);
      line.closed = extend(line);
      if (!line.closed) {
        for (auto& [edge, forward] : line.edges) forward = !forward;
        std::reverse(line.edges.begin(), line.edges.end());
        extend(line);
      }
      lines.push_back(std::move(line));
    }
    return lines;
  }

 private:
  /// Appends edges to the end of the line; true when it comes back to its start.
  bool extend(EdgeLine& line) {
    for (;;) {
      const auto [last, forward] = line.edges.back();
      const BorderEdge& border = *edges_[last].border;
      const Eigen::Vector3d* vertex = forward ? border.to_corner : border.from_corner;
      const Eigen::Vector3d heading = (forward ? 1.0 : -1.0) * edges_[last].along();
      const std::vector<std::size_t>& here = at_vertex_.at(vertex);
      if (here.size() != 2) return false;
      const std::size_t next = here[0] == last ? here[1] : here[0];
      const BorderEdge& beyond = *edges_[next].border;
      const bool next_forward = beyond.from_corner == vertex;
      const Eigen::Vector3d next_heading = (next_forward ? 1.0 : -1.0) * edges_[next].along();
      if (beyond.convex != border.convex || heading.dot(next_heading) < kStraightOn) return false;
      if (next == line.edges.front().first) return line.edges.size() > 2;
      if (taken_[next]) return false;
      taken_[next] = 1;
      line.edges.emplace_back(next, next_forward);
    }
  }

  const std::vector<SharpEdge>& edges_;
  std::vector<std::uint8_t> taken_;
  std::unordered_map<const Eigen::Vector3d*, std::vector<std::size_t>> at_vertex_;
};

/// The line of centres of one row: points with the distance travelled up to each.
struct CentreLine {
  std::vector<Eigen::Vector3d> centres, feet;
  std::vector<double> travelled;

  void append(const Eigen::Vector3d& centre, const Eigen::Vector3d& foot) {
    travelled.push_back(centres.empty() ? 0 : travelled.back() + (centre - centres.back()).norm());
    centres.push_back(centre);
    feet.push_back(foot);
  }
  double length() const { return travelled.back(); }
  std::pair<Eigen::Vector3d, Eigen::Vector3d> at(double distance) const {
    const auto above = std::upper_bound(travelled.begin() + 1, travelled.end() - 1, distance);
    const auto i = static_cast<std::size_t>(above - travelled.begin());
    const double stretch = travelled[i] - travelled[i - 1];
    const double t = stretch > 0 ? (distance - travelled[i - 1]) / stretch : 0;
    return {centres[i - 1] + t * (centres[i] - centres[i - 1]), feet[i - 1] + t * (feet[i] - feet[i - 1])};
  }
};

/// Where the centre below a point of an edge lies, relative to it. `share` runs from 0 (below the one face)
/// to 1 (below the other) on the arc of an inner edge and has no meaning at convex edges.
Eigen::Vector3d below_edge(const SharpEdge& edge, double share, double depth) {
  const double cosine = edge.normal.dot(edge.other_normal);
  if (edge.border->convex) return -depth / (1 + cosine) * (edge.normal + edge.other_normal);
  const double angle = edge.border->angle;
  return -depth *
         ((std::sin((1 - share) * angle) * edge.normal + std::sin(share * angle) * edge.other_normal) /
          std::sin(angle))
             .normalized();
}

CentreLine centre_line(const std::vector<SharpEdge>& edges, const EdgeLine& line, double share,
                       double depth) {
  CentreLine centres;
  const std::size_t count = line.edges.size();
  std::vector<Eigen::Vector3d> below;
  // The faces of an inner edge swap sides where the line travels against an edge.
  for (const auto& [index, forward] : line.edges)
    below.push_back(below_edge(edges[index], forward ? share : 1 - share, depth));
  for (std::size_t i = 0; i <= count; ++i) {
    const auto [index, forward] = line.edges[std::min(i, count - 1)];
    const BorderEdge& border = *edges[index].border;
    const Eigen::Vector3d& corner = forward == (i < count) ? border.from() : border.to();
    const Eigen::Vector3d& before = below[i > 0 ? i - 1 : line.closed ? count - 1 : 0];
    const Eigen::Vector3d& after = below[i < count ? i : line.closed ? 0 : count - 1];
    centres.append(corner + (before + after) / 2, corner);
  }
  return centres;
}

/// First distance along the line, coming from `begin` towards `end`, at which a centre is deep enough below
/// all faces.
double first_valid(const CentreLine& line, const OffsetSurface& offset, double begin, double end) {
  const auto valid = [&](double distance) { return offset.is_deep_enough(line.at(distance).first); };
  const double step = std::copysign(offset.depth() / 4, end - begin);
  double bad = begin;
  double good = begin;
  while (!valid(good)) {
    bad = good;
    good += step;
    if ((good - end) * step > 0) return end;
  }
  for (int i = 0; good != bad && i < kBisections; ++i) {
    const double middle = (good + bad) / 2;
    (valid(middle) ? good : bad) = middle;
  }
  return good;
}

void add_row(const CentreLine& line, bool closed, WallLayout& layout) {
  double begin = 0;
  double end = line.length();
  if (!closed) {
    begin = first_valid(line, layout.offset(), 0, line.length());
    end = first_valid(line, layout.offset(), line.length(), 0);
  }
  if (end < begin) return;
  const int intervals = static_cast<int>(std::ceil((end - begin) / layout.spacing() - 1e-9));
  const double step = intervals > 0 ? (end - begin) / intervals : 0;
  const double least_distance = intervals > 0
                                    ? std::min(WallLayout::kMinDistance * layout.spacing(), 0.9 * step)
                                    : WallLayout::kMinDistance * layout.spacing();
  for (int i = 0; i < intervals + (closed ? 0 : 1); ++i) {
    const auto [centre, foot] = line.at(begin + i * step);
    layout.add(centre, foot, least_distance);
  }
}

}  // namespace

void add_edge_rows(const Facets& facets, WallLayout& layout) {
  const std::vector<SharpEdge> edges = sharp_edges(facets);
  const double depth = layout.offset().depth();
  for (const EdgeLine& line : LineFinder(edges).find()) {
    const SharpEdge& first = edges[line.edges.front().first];
    if (first.border->convex) {
      if (1 + first.normal.dot(first.other_normal) > kSharpestWedge)
        add_row(centre_line(edges, line, 0, depth), line.closed, layout);
      continue;
    }
    const int arcs =
        std::max(1, static_cast<int>(std::ceil(depth * first.border->angle / layout.spacing() - 1e-9)));
    for (int i = 0; i <= arcs; ++i)
      add_row(centre_line(edges, line, static_cast<double>(i) / arcs, depth), line.closed, layout);
  }
}

}  // namespace diefill::geometry
