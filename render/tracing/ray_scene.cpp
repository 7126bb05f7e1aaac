#include "render/tracing/ray_scene.h"

#include <embree3/rtcore.h>

#include <Eigen/Geometry>
#include <limits>
#include <stdexcept>
#include <string>

namespace diefill::render {
namespace {

constexpr unsigned kSpheres = 0, kTriangles = 1;  // numbers of the geometries

void note_error(void* first, RTCError, const char* message) {
  auto& text = *static_cast<std::string*>(first);
  if (text.empty()) text = message != nullptr ? message : "no reason given";
}

RTCRay ray_of(const Eigen::Vector3f& origin, const Eigen::Vector3f& direction, float nearest,
              float farthest) {
  RTCRay ray{};
  ray.org_x = origin.x();
  ray.org_y = origin.y();
  ray.org_z = origin.z();
  ray.dir_x = direction.x();
  ray.dir_y = direction.y();
  ray.dir_z = direction.z();
  ray.tnear = nearest;
  ray.tfar = farthest;
  ray.mask = ~0U;
  return ray;
}

}  // namespace

struct RayScene::Embree {
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;
  std::string error;

  Embree() {
    device = rtcNewDevice(nullptr);
    if (device == nullptr) throw std::runtime_error("Embree cannot be started; use --renderer opengl");
    rtcSetDeviceErrorFunction(device, note_error, &error);
    scene = rtcNewScene(device);
    rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
  }
  ~Embree() {
    rtcReleaseScene(scene);
    rtcReleaseDevice(device);
  }
  Embree(const Embree&) = delete;
  Embree& operator=(const Embree&) = delete;

  void attach(RTCGeometry geometry, unsigned number) {
    rtcCommitGeometry(geometry);
    rtcAttachGeometryByID(scene, geometry, number);
    rtcReleaseGeometry(geometry);
  }
};

RayScene::RayScene(TracedSpheres spheres, TracedTriangles triangles)
    : spheres_(std::move(spheres)), triangles_(std::move(triangles)), embree_(std::make_unique<Embree>()) {
  if (!spheres_.spheres.empty()) add_spheres();
  if (!triangles_.triangles.empty()) add_triangles();
  rtcCommitScene(embree_->scene);
  if (!embree_->error.empty()) throw std::runtime_error("Embree: " + embree_->error);
}

RayScene::~RayScene() = default;

void RayScene::add_spheres() {
  RTCGeometry geometry = rtcNewGeometry(embree_->device, RTC_GEOMETRY_TYPE_SPHERE_POINT);
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4, spheres_.spheres.data(),
                             0, sizeof(Eigen::Vector4f), spheres_.spheres.size());
  embree_->attach(geometry, kSpheres);
}

void RayScene::add_triangles() {
  // Embree reads 16 bytes for each corner: one more at the end.
  triangles_.corners.emplace_back(Eigen::Vector3f::Zero());
  RTCGeometry geometry = rtcNewGeometry(embree_->device, RTC_GEOMETRY_TYPE_TRIANGLE);
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                             triangles_.corners.data(), 0, sizeof(Eigen::Vector3f),
                             triangles_.corners.size() - 1);
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                             triangles_.triangles.data(), 0, 3 * sizeof(std::uint32_t),
                             triangles_.triangles.size());
  embree_->attach(geometry, kTriangles);
}

RayHit RayScene::first_hit(const Eigen::Vector3f& origin, const Eigen::Vector3f& direction,
                           float nearest) const {
  RTCRayHit query{};
  query.ray = ray_of(origin, direction, nearest, std::numeric_limits<float>::infinity());
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcIntersect1(embree_->scene, &context, &query);
  RayHit hit;
  hit.distance = query.ray.tfar;
  const std::size_t primitive = query.hit.primID;
  if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) {
    hit.distance = std::numeric_limits<float>::infinity();
    return hit;
  }
  // Places from the body, not from the ray: they are exact however far the eye is.
  if (query.hit.geomID == kSpheres) {
    const Eigen::Vector4f& sphere = spheres_.spheres[primitive];
    hit.normal = (origin + hit.distance * direction - sphere.head<3>()).normalized();
    hit.place = sphere.head<3>() + sphere.w() * hit.normal;
    hit.colour = spheres_.colours[primitive];
  } else {
    const auto& corners = triangles_.triangles[primitive];
    const float u = query.hit.u, v = query.hit.v, w = 1 - u - v;
    const auto mean = [&](const std::vector<Eigen::Vector3f>& of) -> Eigen::Vector3f {
      return w * of[corners[0]] + u * of[corners[1]] + v * of[corners[2]];
    };
    hit.triangle = true;
    hit.place = mean(triangles_.corners);
    hit.normal = mean(triangles_.normals).normalized();
    hit.colour = triangles_.colours[primitive];
  }
  if (hit.normal.dot(direction) > 0) hit.normal = -hit.normal;
  return hit;
}

bool RayScene::occluded(const Eigen::Vector3f& origin, const Eigen::Vector3f& direction, float nearest,
                        float farthest) const {
  RTCRay ray = ray_of(origin, direction, nearest, farthest);
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcOccluded1(embree_->scene, &context, &ray);
  return ray.tfar < 0;  // Embree's mark of a hit
}

}  // namespace diefill::render
