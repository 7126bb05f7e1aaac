#include "geometry/triangle_tree.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

namespace diefill::geometry {

namespace {

constexpr std::uint32_t kLeafSize = 4;
/// Halving 2^32 triangles down to leaves needs at most 32 levels, and each leaves one node waiting.
constexpr std::size_t kStackSize = 64;

double distance_squared(const Box& box, const Eigen::Vector3d& point) {
  return (point.cwiseMax(box.lower).cwiseMin(box.upper) - point).squaredNorm();
}

Eigen::Vector3d middle(const Corners& corners) {
  return (corners[0] + corners[1] + corners[2]) / 3;
}

}  // namespace

TriangleTree::TriangleTree(std::vector<Corners> triangles)
    : triangles_(std::move(triangles)), order_(triangles_.size()), nodes_(1) {
  std::iota(order_.begin(), order_.end(), 0U);
  split(0, 0, static_cast<std::uint32_t>(order_.size()));
}

void TriangleTree::split(std::uint32_t node, std::uint32_t first, std::uint32_t count) {
  Box middles;
  for (std::uint32_t i = first; i < first + count; ++i) {
    const Corners& corners = triangles_[order_[i]];
    for (const Eigen::Vector3d& corner : corners) nodes_[node].box.include(corner);
    middles.include(middle(corners));
  }
  if (count <= kLeafSize) {
    nodes_[node].first = first;
    nodes_[node].count = count;
    return;
  }
  Eigen::Index axis = 0;
  middles.size().maxCoeff(&axis);
  const auto begin = order_.begin() + first;
  std::nth_element(begin, begin + count / 2, begin + count, [&](std::uint32_t a, std::uint32_t b) {
    return std::pair(middle(triangles_[a])[axis], a) < std::pair(middle(triangles_[b])[axis], b);
  });
  const auto left = static_cast<std::uint32_t>(nodes_.size());
  nodes_[node].first = left;
  nodes_.resize(nodes_.size() + 2);
  split(left, first, count / 2);
  split(left + 1, first + count / 2, count - count / 2);
}

TriangleTree::Hit TriangleTree::nearest(const Eigen::Vector3d& point) const {
  struct Waiting {
    std::uint32_t node;
    double distance_squared;
  };
  std::array<Waiting, kStackSize> stack;
  std::size_t depth = 0;
  stack[depth++] = {0, 0};
  Hit best;
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
    Waiting near = {node.first, distance_squared(nodes_[node.first].box, point)};
    Waiting far = {node.first + 1, distance_squared(nodes_[node.first + 1].box, point)};
    if (far.distance_squared < near.distance_squared) std::swap(near, far);
    stack[depth++] = far;
    stack[depth++] = near;
  }
  return best;
}

}  // namespace diefill::geometry
