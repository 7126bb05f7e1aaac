#include "geometry/solid/surface_strips.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace diefill::geometry {

namespace {

/// Facets that meet at a smaller angle belong to one smooth surface (rad).
constexpr double kSmoothAngle = 0.56;
/// Facets wider than this many spacings carry a grid of their own.
constexpr double kNarrow = 3;
/// Sine of the largest angle between lines taken as parallel.
constexpr double kParallel = 2e-3;

Eigen::Vector3d direction(const BorderEdge& edge) {
  return (edge.to() - edge.from()).normalized();
}

bool is_smooth(const BorderEdge& edge) {
  return edge.other != kNoFacet && edge.angle < kSmoothAngle;
}

bool parallel(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return a.cross(b).norm() < kParallel;
}

/// Lowest and highest coordinate of a facet's corners along a direction.
struct Range {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
  double size() const { return high - low; }
  void include(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

Range range_along(const Facet& facet, const Eigen::Vector3d& direction) {
  Range range;
  for (const BorderEdge& edge : facet.border) range.include(direction.dot(edge.from()));
  return range;
}

/// Inset of the border edge that lies across `direction` at coordinate `end`; 0 where there is none.
double inset_at(const Facet& facet, const Eigen::Vector3d& along, double end, double depth) {
  const double tolerance = 1e-3 * depth;
  for (const BorderEdge& edge : facet.border)
    if (std::abs(along.dot(edge.from()) - end) < tolerance &&
        std::abs(along.dot(edge.to()) - end) < tolerance)
      return inset(edge, depth);
  return 0;
}

/// Properties of each facet before runs are formed.
struct Candidate {
  Eigen::Vector3d axis = Eigen::Vector3d::Zero();  ///< direction of the longest smooth edge
  bool narrow = false;
  std::vector<const BorderEdge*> links;  ///< to the next facets of a run
};

std::vector<Candidate> find_candidates(const Facets& facets, double spacing) {
  std::vector<Candidate> candidates(facets.size());
  for (std::size_t f = 0; f < candidates.size(); ++f) {
    const Facet& facet = facets[f];
    double longest = 0;
    for (const BorderEdge& edge : facet.border) {
      const double edge_length = (edge.to() - edge.from()).norm();
      if (!is_smooth(edge) || edge_length <= longest) continue;
      longest = edge_length;
      candidates[f].axis = direction(edge);
    }
    if (longest == 0) continue;
    const Eigen::Vector3d across = candidates[f].axis.cross(facet.normal);
    candidates[f].narrow = range_along(facet, across).size() < kNarrow * spacing;
  }
  for (std::size_t f = 0; f < candidates.size(); ++f) {
    if (!candidates[f].narrow) continue;
    for (const BorderEdge& edge : facets[f].border) {
      if (!is_smooth(edge) || !parallel(direction(edge), candidates[f].axis)) continue;
      const Candidate& other = candidates[static_cast<std::size_t>(edge.other)];
      const bool known = std::any_of(candidates[f].links.begin(), candidates[f].links.end(),
                                     [&](const BorderEdge* link) { return link->other == edge.other; });
      if (!known && other.narrow && parallel(other.axis, candidates[f].axis))
        candidates[f].links.push_back(&edge);
    }
  }
  return candidates;
}

/// A run of facets in order, and the edges between them.
struct Run {
  std::vector<std::size_t> facets;
  std::vector<const BorderEdge*>
      joints;  ///< joints[i] leads from facet i to facet i + 1 (round to 0 when closed)
  bool closed = false;
};

/// Walks from `start` over links to facets not taken yet. Facets linked to more than two others end the walk.
Run walk(const std::vector<Candidate>& candidates, std::size_t start, std::vector<std::uint8_t>& taken) {
  Run run;
  run.facets.push_back(start);
  taken[start] = 1;
  for (std::size_t current = start;;) {
    const BorderEdge* next = nullptr;
    for (const BorderEdge* link : candidates[current].links) {
      const auto other = static_cast<std::size_t>(link->other);
      if (!taken[other] && candidates[other].links.size() <= 2) {
        next = link;
        break;
      }
      const bool back_at_start = other == start && run.facets.size() > 2;
      if (back_at_start) {
        run.joints.push_back(link);
        run.closed = true;
        return run;
      }
    }
    if (next == nullptr) return run;
    run.joints.push_back(next);
    current = static_cast<std::size_t>(next->other);
    run.facets.push_back(current);
    taken[current] = 1;
  }
}

/// Runs through all facets that are linked to at most two others: ends first, then closed rings.
std::vector<Run> find_runs(const std::vector<Candidate>& candidates) {
  std::vector<Run> runs;
  std::vector<std::uint8_t> taken(candidates.size(), 0);
  for (const std::size_t links : {std::size_t{1}, std::size_t{2}})
    for (std::size_t f = 0; f < candidates.size(); ++f)
      if (!taken[f] && candidates[f].links.size() == links) runs.push_back(walk(candidates, f, taken));
  return runs;
}

/// Builds the unrolled strip of a run, one piece after the other.
class StripBuilder {
 public:
  StripBuilder(const Facets& facets, double depth) : facets_(facets), depth_(depth) {}

  Strip build(const Run& run, const Eigen::Vector3d& axis) {
    strip_ = Strip();
    strip_.axis = axis;
    strip_.closed = run.closed;
    orient_axis(run);
    Range v;
    for (std::size_t i = 0; i < run.facets.size(); ++i) {
      const Facet& facet = facets_[run.facets[i]];
      strip_.area += facet.area;
      const Range own = range_along(facet, strip_.axis);
      v.include(own.low);
      v.include(own.high);
      add_facet(run, i);
    }
    const Facet& first = facets_[run.facets.front()];
    strip_.low = v.low + inset_at(first, strip_.axis, v.low, depth_);
    strip_.high = v.high - inset_at(first, strip_.axis, v.high, depth_);
    return std::move(strip_);
  }

 private:
  Eigen::Vector3d across(const Facet& facet) const { return strip_.axis.cross(facet.normal).normalized(); }

  /// Makes u grow from the first facet towards the second.
  void orient_axis(const Run& run) {
    if (run.joints.empty()) return;
    const Facet& first = facets_[run.facets.front()];
    const Range range = range_along(first, across(first));
    if (across(first).dot(run.joints.front()->from()) < (range.low + range.high) / 2)
      strip_.axis = -strip_.axis;
  }

  const BorderEdge* joint_before(const Run& run, std::size_t i) const {
    if (i > 0) return run.joints[i - 1];
    return run.closed ? run.joints.back() : nullptr;
  }
  const BorderEdge* joint_after(const Run& run, std::size_t i) const {
    return i < run.joints.size() ? run.joints[i] : nullptr;
  }

  void add_facet(const Run& run, std::size_t i) {
    const Facet& facet = facets_[run.facets[i]];
    const Eigen::Vector3d u = across(facet);
    const Range range = range_along(facet, u);
    const BorderEdge* before = joint_before(run, i);
    const BorderEdge* after = joint_after(run, i);
    const double begin = before ? u.dot(before->from()) + inset(*before, depth_)
                                : range.low + inset_at(facet, u, range.low, depth_);
    const double end = after ? u.dot(after->from()) - inset(*after, depth_)
                             : range.high - inset_at(facet, u, range.high, depth_);
    StripPiece piece;
    piece.normal = facet.normal;
    piece.along = u;
    piece.start = u * begin + facet.normal * (facet.offset - depth_);
    append(piece, std::max(0.0, end - begin));
    if (after && !after->convex) add_arc(*after, facet, facets_[static_cast<std::size_t>(after->other)]);
  }

  void add_arc(const BorderEdge& joint, const Facet& facet, const Facet& next) {
    StripPiece arc;
    arc.is_arc = true;
    arc.pivot = joint.from() - strip_.axis * strip_.axis.dot(joint.from());
    arc.normal = facet.normal;
    arc.along = across(facet);
    arc.start = arc.pivot - depth_ * facet.normal;
    append(arc, depth_ * std::acos(std::clamp(facet.normal.dot(next.normal), -1.0, 1.0)));
  }

  void append(StripPiece& piece, double piece_length) {
    if (piece_length <= 0) return;
    piece.begin = strip_.length;
    piece.length = piece_length;
    strip_.length += piece_length;
    strip_.pieces.push_back(piece);
  }

  const Facets& facets_;
  double depth_;
  Strip strip_;
};

/// Direction of the longest straight stretch of a facet's border.
Eigen::Vector3d longest_border(const Facet& facet) {
  const BorderEdge* longest = nullptr;
  for (const BorderEdge& edge : facet.border)
    if (longest == nullptr ||
        (edge.to() - edge.from()).squaredNorm() > (longest->to() - longest->from()).squaredNorm())
      longest = &edge;
  return longest == nullptr ? Eigen::Vector3d(facet.normal.unitOrthogonal()) : direction(*longest);
}

bool is_part_of_curved_surface(const Facet& facet, double spacing) {
  const Eigen::Vector3d axis = longest_border(facet);
  const bool small = range_along(facet, axis).size() < kNarrow * spacing ||
                     range_along(facet, axis.cross(facet.normal)).size() < kNarrow * spacing;
  return small && std::any_of(facet.border.begin(), facet.border.end(), is_smooth);
}

void sort_by_area(std::vector<Strip>& strips) {
  std::stable_sort(strips.begin(), strips.end(),
                   [](const Strip& a, const Strip& b) { return a.area > b.area; });
}

}  // namespace

StripPoint Strip::at(double u, double v, double depth) const {
  const auto after =
      std::upper_bound(pieces.begin(), pieces.end(), u,
                       [](double value, const StripPiece& piece) { return value < piece.begin; });
  const StripPiece& piece = after == pieces.begin() ? *after : *(after - 1);
  const double t = u - piece.begin;
  if (!piece.is_arc) {
    const Eigen::Vector3d centre = piece.start + t * piece.along + v * axis;
    return {centre, centre + depth * piece.normal, piece.normal};
  }
  // About an edge that is not convex the normal turns against the way across.
  const double angle = t / depth;
  const Eigen::Vector3d normal = std::cos(angle) * piece.normal - std::sin(angle) * piece.along;
  const Eigen::Vector3d foot = piece.pivot + v * axis;
  return {foot - depth * normal, foot, normal};
}

Strips find_strips(const Facets& facets, double depth, double spacing) {
  Strips strips;
  StripBuilder builder(facets, depth);
  const std::vector<Candidate> candidates = find_candidates(facets, spacing);
  std::vector<std::uint8_t> in_strip(facets.size(), 0);
  for (const Run& run : find_runs(candidates)) {
    Strip strip = builder.build(run, candidates[run.facets.front()].axis);
    const bool too_small = strip.length < kNarrow * spacing || strip.high - strip.low < kNarrow * spacing;
    if (run.facets.size() < 3 || too_small || strip.pieces.empty()) continue;
    for (const std::size_t f : run.facets) in_strip[f] = 1;
    strips.bent.push_back(std::move(strip));
  }
  for (std::size_t f = 0; f < facets.size(); ++f) {
    if (in_strip[f] || is_part_of_curved_surface(facets[f], spacing)) continue;
    Strip strip = builder.build({{f}, {}, false}, longest_border(facets[f]));
    if (!strip.pieces.empty() && strip.high >= strip.low) strips.plane.push_back(std::move(strip));
  }
  sort_by_area(strips.bent);
  sort_by_area(strips.plane);
  return strips;
}

}  // namespace diefill::geometry
