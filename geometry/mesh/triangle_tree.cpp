#include "geometry/mesh/triangle_tree.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "geometry/grids/all_cores.h"

namespace diefill::geometry {

namespace {

/// Distances squared in a smaller ratio may differ by rounding alone.
constexpr double kHardlyMore = 1 + 1e-9;
/// How much farther than the nearest triangle so far a search reaches, over that distance and over the
/// largest coordinate: several times what single precision rounds.
constexpr double kFarther = 1e-6;

float float_below(double value) {
  const auto near = static_cast<float>(value);
  return near > value ? std::nextafter(near, -std::numeric_limits<float>::infinity()) : near;
}

float float_above(double value) {
  return -float_below(-value);
}

/// One for all trees: starting it takes longer than building a small one.
RTCDevice device() {
  static const std::unique_ptr<RTCDeviceTy, void (*)(RTCDevice)> kept(rtcNewDevice(nullptr),
                                                                      rtcReleaseDevice);
  return kept.get();
}

Box box_of(const Corners& corners) {
  Box box;
  for (const Eigen::Vector3d& corner : corners) box.include(corner);
  return box;
}

}  // namespace

/// Boxes of the triangles of a tree in Embree, about the middle of all.
class TriangleTree::Scene {
 public:
  explicit Scene(const TriangleTree& tree)
      : tree_(tree), middle_((tree.box_.lower + tree.box_.upper) / 2), scene_(rtcNewScene(device())) {
    RTCGeometry geometry = rtcNewGeometry(device(), RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(tree.count_));
    rtcSetGeometryUserData(geometry, this);
    rtcSetGeometryBoundsFunction(geometry, give_box, nullptr);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene_, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene_);
    if (rtcGetDeviceError(device()) != RTC_ERROR_NONE) {
      rtcReleaseScene(scene_);
      throw std::runtime_error("cannot build the search tree of " + std::to_string(tree.count_) +
                               " triangles; the memory is probably exhausted");
    }
  }
  ~Scene() { rtcReleaseScene(scene_); }
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;

  /// The nearest triangle, if it is within `reach` (m); another one, or none, otherwise.
  Hit nearest_within(double reach, const Eigen::Vector3d& point) const {
    const double farthest = (point - middle_).cwiseAbs().maxCoeff() + (tree_.box_.upper - middle_).maxCoeff();
    Question question{this, point, kFarther * farthest, {}};
    const Eigen::Vector3f place = (point - middle_).cast<float>();
    alignas(16) RTCPointQuery sphere{place.x(), place.y(), place.z(), 0, question.radius_for(reach)};
    RTCPointQueryContext context;
    rtcInitPointQueryContext(&context);
    rtcPointQuery(scene_, &sphere, &context, test_triangle, &question);
    question.hit.alone = question.others > question.hit.distance_squared * kHardlyMore;
    return question.hit;
  }

 private:
  struct Question {
    const Scene* scene;
    Eigen::Vector3d point;
    double margin;  ///< m, what single precision rounds of coordinates
    Hit hit;
    double others = std::numeric_limits<double>::infinity();  ///< m^2, no other triangle is nearer

    float radius_for(double distance) const { return float_above(distance * (1 + kFarther) + margin); }
  };

  /// Called on all cores.
  static void give_box(const RTCBoundsFunctionArguments* asked) {
    const auto& scene = *static_cast<const Scene*>(asked->geometryUserPtr);
    const Box box = box_of(scene.tree_.triangles_[asked->primID]);
    const Eigen::Vector3d lower = box.lower - scene.middle_, upper = box.upper - scene.middle_;
    RTCBounds& bounds = *asked->bounds_o;
    bounds.lower_x = float_below(lower.x());
    bounds.lower_y = float_below(lower.y());
    bounds.lower_z = float_below(lower.z());
    bounds.upper_x = float_above(upper.x());
    bounds.upper_y = float_above(upper.y());
    bounds.upper_z = float_above(upper.z());
  }

  /// Called with each triangle that may be within the radius; says whether that has become smaller.
  static bool test_triangle(RTCPointQueryFunctionArguments* proposed) {
    auto& question = *static_cast<Question*>(proposed->userPtr);
    const std::size_t triangle = proposed->primID;
    const TriangleFoot foot = closest_point(question.scene->tree_.triangles_[triangle], question.point);
    const double distance = (foot.point - question.point).squaredNorm();
    Hit& hit = question.hit;
    question.others = std::min(question.others, std::max(distance, hit.distance_squared));
    // Neither holds for the distance of a triangle without area.
    const bool nearer = distance < hit.distance_squared;
    const bool as_near = distance == hit.distance_squared && triangle < hit.triangle;
    if (!nearer && !as_near) return false;
    hit = {triangle, foot, distance, false};
    const float radius = question.radius_for(std::sqrt(distance));
    if (!nearer || radius >= proposed->query->radius) return false;
    proposed->query->radius = radius;
    return true;
  }

  const TriangleTree& tree_;
  Eigen::Vector3d middle_;  ///< m
  RTCScene scene_;
};

TriangleTree::TriangleTree(std::size_t count, const std::function<Corners(std::size_t)>& corners_of)
    : count_(count), triangles_(std::make_unique_for_overwrite<Corners[]>(count)) {
  in_parts_on_all_cores(count, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) triangles_[t] = corners_of(t);
  });
  for (const Corners& corners : triangles()) box_.include(box_of(corners));
  scene_ = std::make_unique<const Scene>(*this);
}

TriangleTree::~TriangleTree() = default;

TriangleTree::Hit TriangleTree::nearest(const Eigen::Vector3d& point) const {
  return scene_->nearest_within(std::numeric_limits<float>::max() / 2, point);
}

TriangleTree::Hit TriangleTree::nearest(const Eigen::Vector3d& point, double guess) const {
  const Hit hit = scene_->nearest_within(guess, point);
  return hit.distance_squared <= guess * guess ? hit : nearest(point);
}

}  // namespace diefill::geometry
