#include "engine/contact/mesh_contacts.h"

#include <algorithm>
#include <span>

namespace diefill::engine {

namespace {

/// Over the sphere's radius: places on a seam that differ by less are one. CAD in single precision leaves
/// gaps of a few 1e-9 m where a corner of one triangle lies on the edge of another.
constexpr double kSamePlace = 1e-5;
/// Over the radius, distance of a centre that has come behind the surface: it still has a side to be pushed
/// to.
constexpr double kBehind = 1e-9;
/// Cosine of 15 degrees: normals that differ by less belong to one smooth surface.
constexpr double kSmooth = 0.9659258262890683;

/// Whether directions `a` and `b` (of any length) differ by less than facets of one surface do.
bool same_direction(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  const double along = a.dot(b);
  return along > 0 && along * along > kSmooth * kSmooth * a.squaredNorm() * b.squaredNorm();
}

/// The triangles that one sphere overlaps, and which of them it touches in their own right.
class SphereOnMesh {
 public:
  explicit SphereOnMesh(MeshWorkspace& workspace) : feet_(workspace.feet), kept_(workspace.kept) {}

  /// `distance`: of the pairs when the list was made (Block::wall_distance), of which only those below
  /// `within` (m) can be overlapped.
  void look(const WallBody& body, const Eigen::Vector3d& place, std::uint32_t sphere_class, double radius,
            std::span<const WallPair> near, const float* distance, double within) {
    body_ = &body;
    class_ = sphere_class;
    place_ = place;
    tolerance_ = kSamePlace * radius;
    radius_ = radius;
    feet_.clear();
    for (std::uint32_t k = 0; k < near.size(); ++k) {
      if (!(distance[k] < within)) continue;
      const std::uint32_t part = near[k].wall;
      const NearestPoint nearest = nearest_point(body.triangles()[part], place);
      const Eigen::Vector3d way = place - nearest.point;
      if (way.squaredNorm() >= radius * radius) continue;
      feet_.push_back({k, part, nearest, way.norm(), body.triangle_normals()[part].dot(way)});
    }
  }

  /// Appends the touches, the deepest first; `first` is the number of the pair that `near` began with.
  /// Returns the deepest overlap (m).
  double touch(std::uint32_t first, std::vector<WallTouch>& touches) {
    if (feet_.empty()) return 0;
    const Foot& nearest = *std::min_element(feet_.begin(), feet_.end(), [](const Foot& a, const Foot& b) {
      return a.distance != b.distance ? a.distance < b.distance : a.height > b.height;
    });
    if (is_behind(nearest)) {
      touches.push_back({first + nearest.near, class_, plain(separation(nearest))});
      return radius_ + nearest.distance;
    }
    kept_.clear();
    for (const Foot& foot : feet_)
      if (foot.height > 0 && (foot.point.inside || is_summit(foot))) kept_.push_back(&foot);
    std::sort(kept_.begin(), kept_.end(), [](const Foot* a, const Foot* b) {
      return a->distance != b->distance ? a->distance < b->distance : a->near < b->near;
    });
    const std::size_t before = touches.size();
    for (const Foot* foot : kept_) {
      const Eigen::Vector3d way = separation(*foot);
      const bool known =
          std::any_of(touches.begin() + static_cast<std::ptrdiff_t>(before), touches.end(),
                      [&](const WallTouch& t) { return same_direction(eigen(t.separation), way); });
      if (!known) touches.push_back({first + foot->near, class_, plain(way)});
    }
    return kept_.empty() ? 0 : radius_ - kept_.front()->distance;
  }

 private:
  using Foot = TriangleFoot;

  Eigen::Vector3d separation(const Foot& foot) const {
    return separation_from_triangle(*body_, foot.part, place_, radius_);
  }

  bool at_same_place(const Foot& one, const Foot& other) const {
    return (one.point.point - other.point.point).squaredNorm() <= tolerance_ * tolerance_;
  }

  /// Whether the sphere's centre is on the wrong side of the surface there, which is nearest of all.
  bool is_behind(const Foot& nearest) const {
    return std::none_of(feet_.begin(), feet_.end(), [&](const Foot& other) {
      return other.height > 0 && (&other == &nearest || at_same_place(nearest, other));
    });
  }

  /// Whether the surface is nearest to the centre at this point of an edge or corner, and this triangle is
  /// the one to say so: the first of those that see most of the centre.
  bool is_summit(const Foot& foot) const {
    for (const Foot& other : feet_) {
      if (&other == &foot || !reaches(other.part, foot.point.point)) continue;
      if (!at_same_place(foot, other)) return false;
      if (other.height > foot.height || (other.height == foot.height && other.near < foot.near)) return false;
    }
    return true;
  }

  bool reaches(std::uint32_t part, const Eigen::Vector3d& point) const {
    const WallTriangle& triangle = body_->triangles()[part];
    if (std::abs(body_->triangle_normals()[part].dot(point - triangle.corner[0])) > tolerance_) return false;
    return (nearest_point(triangle, point).point - point).squaredNorm() <= tolerance_ * tolerance_;
  }

  const WallBody* body_ = nullptr;
  Eigen::Vector3d place_ = Eigen::Vector3d::Zero();
  std::uint32_t class_ = 0;
  double radius_ = 0, tolerance_ = 0;
  std::vector<Foot>& feet_;
  std::vector<const Foot*>& kept_;
};

/// The end of the run of pairs of one sphere that begins at `p`.
std::uint32_t end_of_run(const PairTable<WallPair>& table, std::uint32_t p, std::uint32_t end) {
  const LocalSphere own = table.pair[p].own;
  while (p < end && table.pair[p].own == own) ++p;
  return p;
}

/// The pair of the sphere's run [begin, end) whose contact has just ended and was most like `touch`; `end`
/// for none.
std::uint32_t forerunner(const PairTable<WallPair>& table, const MeshPairs& near, std::uint32_t begin,
                         std::uint32_t end, const std::vector<std::uint8_t>& touches_now,
                         const WallTouch& touch) {
  const LocalSphere own = table.pair[begin].own;
  const Eigen::Vector3d place = near.place_of(own), way = eigen(touch.separation);
  std::uint32_t best = end;
  double nearest = 0;
  for (std::uint32_t q = begin; q < end; ++q) {
    if (!table.touching[q] || touches_now[q - near.begin()]) continue;
    const Eigen::Vector3d earlier =
        separation_from_triangle(near.body, table.pair[q].wall, place, near.radius_of(own));
    const double apart = (earlier - way).squaredNorm();
    if (!same_direction(earlier, way) || (best != end && apart >= nearest)) continue;
    best = q;
    nearest = apart;
  }
  return best;
}

}  // namespace

Eigen::Vector3d separation_from_triangle(const WallBody& body, std::uint32_t part,
                                         const Eigen::Vector3d& place, double radius) {
  const WallTriangle& triangle = body.triangles()[part];
  const Eigen::Vector3d& normal = body.triangle_normals()[part];
  const NearestPoint nearest = nearest_point(triangle, place);
  // Along the normal itself, so that all triangles of a plane give the same to rounding.
  const double height = normal.dot(place - triangle.corner[0]);
  if (height <= 0) return kBehind * radius * normal;
  return nearest.inside ? Eigen::Vector3d(height * normal) : Eigen::Vector3d(place - nearest.point);
}

DeepestOnMesh find_mesh_touches(const MeshPairs& near, MeshWorkspace& workspace,
                                std::vector<WallTouch>& touches) {
  SphereOnMesh sphere(workspace);
  const Block& block = near.block;
  DeepestOnMesh deepest;
  for (std::uint32_t r = block.wall_run_first[near.number]; r < block.wall_run_first[near.number + 1]; ++r) {
    const WallRun& run = block.wall_runs[r];
    const std::uint32_t first = run.first, count = block.wall_runs[r + 1].first - first;
    const Eigen::Vector3d place = near.place_of(run.own);
    const double radius = near.radius_of(run.own);
    sphere.look(near.body, place, near.class_of(run.own), radius,
                std::span(block.wall_pairs.pair).subspan(first, count), block.wall_distance.data() + first,
                run.within(plain(place), radius));
    const double overlap = sphere.touch(first, touches);
    deepest.overlap = std::max(deepest.overlap, overlap);
    deepest.over_radius = std::max(deepest.over_radius, overlap / radius);
  }
  return deepest;
}

void note_mesh_touches(PairTable<WallPair>& table, const MeshPairs& near,
                       const std::vector<WallTouch>& touches, MeshWorkspace& workspace) {
  std::vector<std::uint8_t>& now = workspace.touches_now;
  now.assign(near.end() - near.begin(), 0);
  for (const auto& touch : touches) now[touch.pair - near.begin()] = 1;
  for (const auto& touch : touches) {
    if (table.touching[touch.pair]) continue;
    std::uint32_t begin = touch.pair;
    while (begin > near.begin() && table.pair[begin - 1].own == table.pair[touch.pair].own) --begin;
    const std::uint32_t end = end_of_run(table, begin, near.end());
    const std::uint32_t before = forerunner(table, near, begin, end, now, touch);
    std::fill_n(table.history_of(touch.pair), table.width, 0.0);
    if (before == end) continue;
    std::copy_n(table.history_of(before), table.width, table.history_of(touch.pair));
    table.touching[before] = 0;
  }
  std::copy(now.begin(), now.end(), table.touching.begin() + near.begin());
}

}  // namespace diefill::engine
