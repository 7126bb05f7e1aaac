#include "geometry/triangle_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "geometry/all_cores.h"

namespace diefill::geometry {

namespace {

constexpr std::uint32_t kLeafSize = 4;
constexpr std::uint32_t kWorthAThread = 20000;  // triangles
/// Halving 2^32 triangles down to leaves needs at most 32 levels, and each leaves one node waiting.
constexpr std::size_t kStackSize = 64;
/// Distances squared in a smaller ratio may differ by rounding alone.
constexpr double kHardlyMore = 1 + 1e-9;

float rounded_down(double value) {
  const auto near = static_cast<float>(value);
  return near > value ? std::nextafter(near, -std::numeric_limits<float>::infinity()) : near;
}

Eigen::Vector3d middle(const Corners& corners) {
  return (corners[0] + corners[1] + corners[2]) / 3;
}

}  // namespace

void TriangleTree::Node::enclose(const Box& box) {
  lower = box.lower.unaryExpr([](double value) { return rounded_down(value); });
  upper = box.upper.unaryExpr([](double value) { return -rounded_down(-value); });
}

/// Splits the triangles of a tree in halves, large ones on all cores: places in the list of nodes follow from
/// numbers of triangles alone, so that the tree is the same on any number of threads.
class TriangleTree::Builder {
 public:
  explicit Builder(TriangleTree& tree) : tree_(tree) {
    middles_.reserve(tree.triangles_.size());
    for (const Corners& corners : tree.triangles_) middles_.push_back(middle(corners));
    const auto count = static_cast<std::uint32_t>(tree.order_.size());
    tree.nodes_.resize(1 + nodes_below(count));
    tree.box_ = split(0, {0, count}, 1);
  }

 private:
  struct Part {
    std::uint32_t first, count;  ///< places in order_
  };

  static std::uint32_t nodes_below(std::uint32_t count) {
    return count <= kLeafSize ? 0 : 2 + nodes_below(count / 2) + nodes_below(count - count / 2);
  }

  /// Makes the nodes of a part, and says in which box it lies. `free`: place of the first node that is not
  /// taken.
  Box split(std::uint32_t place, Part part, std::uint32_t free) {
    Node& node = tree_.nodes_[place];
    const auto begin = tree_.order_.begin() + part.first, end = begin + part.count;
    Box box;
    if (part.count <= kLeafSize) {
      for (auto own = begin; own != end; ++own)
        for (const Eigen::Vector3d& corner : tree_.triangles_[*own]) box.include(corner);
      node.first = part.first;
      node.count = part.count;
      node.enclose(box);
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
    node.first = free;
    const std::uint32_t free_of_right = free + 2 + nodes_below(left.count);
    Box box_of_right;
    const auto split_left = [&] { box = split(free, left, free + 2); };
    const auto split_right = [&] { box_of_right = split(free + 1, right, free_of_right); };
    if (part.count > kWorthAThread) {
      side_by_side(split_left, split_right);
    } else {
      split_left();
      split_right();
    }
    box.include(box_of_right);
    node.enclose(box);
    return box;
  }

  TriangleTree& tree_;
  std::vector<Eigen::Vector3d> middles_;
};

TriangleTree::TriangleTree(std::vector<Corners> triangles)
    : triangles_(std::move(triangles)), order_(triangles_.size()) {
  std::iota(order_.begin(), order_.end(), 0U);
  Builder{*this};
}

TriangleTree::Hit TriangleTree::nearest(const Eigen::Vector3d& point) const {
  return nearer_than(std::numeric_limits<double>::infinity(), point);
}

// Of triangles equally near the first one met is the answer, and the way through the tree does not depend on
// the guess: with a bound that is larger than the answer it is met first too.
TriangleTree::Hit TriangleTree::nearest(const Eigen::Vector3d& point, double guess) const {
  const double bound = guess * guess * kHardlyMore * kHardlyMore;
  const Hit hit = nearer_than(bound, point);
  return hit.distance_squared * kHardlyMore < bound ? hit : nearest(point);
}

TriangleTree::Hit TriangleTree::nearer_than(double bound, const Eigen::Vector3d& point) const {
  struct Waiting {
    std::uint32_t node;
    double distance_squared;
  };
  std::array<Waiting, kStackSize> stack;
  std::size_t depth = 0;
  stack[depth++] = {0, 0};
  Hit best;
  best.distance_squared = bound;
  while (depth > 0) {
    const Waiting next = stack[--depth];
    if (next.distance_squared >= best.distance_squared) continue;
    const Node& node = nodes_[next.node];
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
      const TriangleFoot foot = closest_point(triangles_[order_[i]], point);
      const double distance = (foot.point - point).squaredNorm();
      if (distance < best.distance_squared) best = {order_[i], foot, distance};
    }
    if (node.count > 0) continue;
    Waiting near = {node.first, nodes_[node.first].distance_squared(point)};
    Waiting far = {node.first + 1, nodes_[node.first + 1].distance_squared(point)};
    if (far.distance_squared < near.distance_squared) std::swap(near, far);
    stack[depth++] = far;
    stack[depth++] = near;
  }
  return best;
}

}  // namespace diefill::geometry
