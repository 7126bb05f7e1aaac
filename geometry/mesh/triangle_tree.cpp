#include "geometry/mesh/triangle_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <numeric>
#include <utility>

#include "geometry/grids/all_cores.h"

namespace diefill::geometry {

namespace {

constexpr std::uint32_t kLeafSize = 4;
constexpr std::uint32_t kWorthAThread = 20000;  // triangles
/// Halving 2^32 triangles down to leaves needs at most 32 levels, and each leaves one node waiting.
constexpr std::size_t kStackSize = 64;
/// Distances squared in a smaller ratio may differ by rounding alone.
constexpr double kHardlyMore = 1 + 1e-9;
/// Radius of a region over the distance asked about first. A wide one holds longer, a narrow one has fewer
/// levels.
constexpr double kRegionRadius = 6;

float rounded_down(double value) {
  const auto near = static_cast<float>(value);
  return near > value ? std::nextafter(near, -std::numeric_limits<float>::infinity()) : near;
}

Eigen::Vector3d middle(const Corners& corners) {
  return (corners[0] + corners[1] + corners[2]) / 3;
}

}  // namespace

void TriangleTree::Siblings::enclose(int side, const Box& box) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto at = static_cast<Eigen::Index>(axis);
    lower[axis][side] = rounded_down(box.lower[at]);
    upper[axis][side] = -rounded_down(-box.upper[at]);
  }
}

Eigen::Array2d TriangleTree::Siblings::distances_squared(const Eigen::Vector3d& point) const {
  const auto along = [&](std::size_t axis) {
    const double place = point[static_cast<Eigen::Index>(axis)];
    const Eigen::Array2d below = lower[axis].cast<double>() - place,
                         above = place - upper[axis].cast<double>();
    return Eigen::Array2d(below.max(above).max(0.0).square());
  };
  return along(0) + (along(1) + along(2));
}

/// Splits the triangles of a tree in halves, large ones on all cores: places in the list of nodes follow from
/// numbers of triangles alone, so that the tree is the same on any number of threads.
class TriangleTree::Builder {
 public:
  explicit Builder(TriangleTree& tree)
      : tree_(tree), middles_(std::make_unique_for_overwrite<Eigen::Vector3d[]>(tree.order_.size())) {
    in_parts_on_all_cores(tree.order_.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t t = begin; t < end; ++t) middles_[t] = middle(tree.triangles_[t]);
    });
    const auto count = static_cast<std::uint32_t>(tree.order_.size());
    tree.nodes_.resize(1 + siblings_below(count));
    tree.box_ = split({0, 0}, {0, count}, 1);
  }

 private:
  struct Part {
    std::uint32_t first, count;  ///< places in order_
  };
  struct Place {
    std::uint32_t siblings;
    int side;
  };

  static std::uint32_t siblings_below(std::uint32_t count) {
    return count <= kLeafSize ? 0 : 1 + siblings_below(count / 2) + siblings_below(count - count / 2);
  }

  /// Makes the nodes of a part, and says in which box it lies. `free`: the first siblings that are not taken.
  Box split(Place place, Part part, std::uint32_t free) {
    Siblings& node = tree_.nodes_[place.siblings];
    const auto side = static_cast<std::size_t>(place.side);
    const auto begin = tree_.order_.begin() + part.first, end = begin + part.count;
    Box box;
    if (part.count <= kLeafSize) {
      for (auto own = begin; own != end; ++own)
        for (const Eigen::Vector3d& corner : tree_.triangles_[*own]) box.include(corner);
      node.first[side] = part.first;
      node.count[side] = part.count;
      node.enclose(place.side, box);
      return box;
    }
    Box middles;
    for (auto own = begin; own != end; ++own) middles.include(middles_[*own]);
    Eigen::Index axis = 0;
    middles.size().maxCoeff(&axis);
    const Part left = {part.first, part.count / 2};
    const Part right = {part.first + left.count, part.count - left.count};
    std::nth_element(begin, begin + left.count, end, [&](std::uint32_t a, std::uint32_t b) {
      return std::pair(middles_[a][axis], a) < std::pair(middles_[b][axis], b);
    });
    node.first[side] = free;
    const std::uint32_t free_of_right = free + 1 + siblings_below(left.count);
    Box box_of_right;
    const auto split_left = [&] { box = split({free, 0}, left, free + 1); };
    const auto split_right = [&] { box_of_right = split({free, 1}, right, free_of_right); };
    if (part.count > kWorthAThread) {
      side_by_side(split_left, split_right);
    } else {
      split_left();
      split_right();
    }
    box.include(box_of_right);
    node.enclose(place.side, box);
    return box;
  }

  TriangleTree& tree_;
  std::unique_ptr<Eigen::Vector3d[]>
      middles_;  ///< of the triangles; memory that each core clears its part of
};

TriangleTree::TriangleTree(std::size_t count, const std::function<Corners(std::size_t)>& corners_of)
    : triangles_(std::make_unique_for_overwrite<Corners[]>(count)), order_(count) {
  in_parts_on_all_cores(count, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) triangles_[t] = corners_of(t);
  });
  std::iota(order_.begin(), order_.end(), 0U);
  Builder{*this};
}

TriangleTree::Hit TriangleTree::nearest(const Eigen::Vector3d& point) const {
  return nearer_than(std::numeric_limits<double>::infinity(), point, everywhere());
}

// Of triangles equally near the first one met is the answer, and the way through the tree does not depend on
// the guess: with a bound that is larger than the answer it is met first too.
TriangleTree::Hit TriangleTree::nearest(const Eigen::Vector3d& point, double guess) const {
  Region region = everywhere();
  return nearest(point, guess, region);
}

// Nor does it depend on the region, outside of which all is farther than the bound.
TriangleTree::Hit TriangleTree::nearest(const Eigen::Vector3d& point, double guess, Region& region) const {
  if ((point - region.middle).norm() + guess * kHardlyMore * kHardlyMore >= region.radius)
    region = region_round(point, kRegionRadius * guess);
  const double bound = guess * guess * kHardlyMore * kHardlyMore;
  const Hit hit = nearer_than(bound, point, region);
  return hit.distance_squared * kHardlyMore < bound ? hit : nearest(point);
}

TriangleTree::Region TriangleTree::everywhere() const {
  return {{0, 0, 0}, std::numeric_limits<double>::infinity(), nodes_[0].first[0], nodes_[0].count[0]};
}

TriangleTree::Region TriangleTree::region_round(const Eigen::Vector3d& middle, double radius) const {
  Region region = everywhere();
  while (region.count == 0) {
    const Siblings& children = nodes_[region.first];
    const Eigen::Array2d distances = children.distances_squared(middle);
    const std::size_t near = distances[1] < distances[0] ? 1 : 0;
    if (distances[static_cast<Eigen::Index>(1 - near)] <= radius * radius) break;
    region.first = children.first[near];
    region.count = children.count[near];
  }
  region.middle = middle;
  region.radius = radius;
  return region;
}

TriangleTree::Hit TriangleTree::nearer_than(double bound, const Eigen::Vector3d& point,
                                            const Region& region) const {
  struct Waiting {
    std::uint32_t first, count;  ///< as in the node
    double distance_squared;
  };
  std::array<Waiting, kStackSize> stack;
  std::size_t depth = 0;
  stack[depth++] = {region.first, region.count, 0};
  Hit best;
  best.distance_squared = bound;
  double others = std::numeric_limits<double>::infinity();  // m^2, no other triangle is nearer
  while (depth > 0) {
    const Waiting next = stack[--depth];
    if (next.distance_squared >= best.distance_squared) {
      others = std::min(others, next.distance_squared);
      continue;
    }
    for (std::uint32_t i = next.first; i < next.first + next.count; ++i) {
      const TriangleFoot foot = closest_point(triangles_[order_[i]], point);
      const double distance = (foot.point - point).squaredNorm();
      others = std::min(others, std::max(distance, best.distance_squared));
      if (distance < best.distance_squared) best = {order_[i], foot, distance, false};
    }
    if (next.count > 0) continue;
    const Siblings& children = nodes_[next.first];
    const Eigen::Array2d distances = children.distances_squared(point);
    const std::size_t near = distances[1] < distances[0] ? 1 : 0;
    for (const std::size_t side : {1 - near, near}) {
      const double distance = distances[static_cast<Eigen::Index>(side)];
      if (distance < best.distance_squared)
        stack[depth++] = {children.first[side], children.count[side], distance};
      else
        others = std::min(others, distance);
    }
  }
  best.alone = others > best.distance_squared * kHardlyMore;
  return best;
}

}  // namespace diefill::geometry
