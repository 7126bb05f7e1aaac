#include "render/tracing/traced_image.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "render/tracing/all_cores.h"
#include "render/tracing/sample_directions.h"

namespace diefill::render {
namespace {

constexpr int kOversampling = 2;
constexpr int kTile = 64;    // pixels along an edge
constexpr int kApron = 2;    // rays beyond a tile, for smoothing
constexpr int kPattern = 4;  // rays along an edge of the pattern of directions
constexpr std::uint32_t kAmbientRays = 2;
// Shares of the light; a surface that faces lamp and eye has about its own colour, as the legend shows it.
constexpr float kAmbient = 0.52F, kLamp = 0.48F, kEye = 0.10F, kGloss = 0.10F;
constexpr float kLampSize = 0.06F;  // tangent of half the angle under which the lamp is seen
constexpr float kGlossPower = 24;

/// One ray from the eye and what it met.
struct Point {
  float distance = std::numeric_limits<float>::infinity();
  Eigen::Vector3f normal = Eigen::Vector3f::Zero(), colour = Eigen::Vector3f::Ones();
  float open = 1, lit = 1;  // shares of the surroundings and of the lamp that reach the place
  Eigen::Vector3f veil = Eigen::Vector3f::Zero();  // colour of what is seen through, already weighted
  float behind = 1;                                // weight of what is behind it
};

Eigen::Vector3f colour_of(const Rgb& colour) {
  return Eigen::Vector3f(colour.red, colour.green, colour.blue) / 255.0F;
}

/// What all rays need.
class Tracer {
 public:
  Tracer(const RayScene& scene, const RayScene* translucent, float opacity, const TracedCamera& camera,
         const TracedLight& light, int width, int height)
      : scene_(scene),
        translucent_(translucent),
        opacity_(opacity),
        camera_(camera),
        light_(light),
        width_(kOversampling * width),
        height_(kOversampling * height),
        pixel_(camera.height / static_cast<float>(height_)),
        lamp_((0.45F * camera.up + 0.75F * camera.to_eye - 0.42F * camera.right).normalized()) {}

  Point point(int column, int row) const {
    const float x = (static_cast<float>(column) + 0.5F - 0.5F * static_cast<float>(width_)) * pixel_;
    const float y = (0.5F * static_cast<float>(height_) - static_cast<float>(row) - 0.5F) * pixel_;
    const Eigen::Vector3f origin =
        camera_.target + x * camera_.right + y * camera_.up + camera_.distance * camera_.to_eye;
    const Eigen::Vector3f direction = -camera_.to_eye;
    const RayHit hit = scene_.first_hit(origin, direction);
    Point point;
    point.distance = hit.distance;
    if (std::isfinite(hit.distance)) {
      point.normal = hit.normal;
      point.colour = colour_of(hit.colour);
      gather_light(point, hit, column, row);
    }
    if (translucent_ != nullptr) look_through(point, origin, direction);
    return point;
  }

  Eigen::Vector3f shade(const Point& point, float open, float lit) const {
    Eigen::Vector3f colour = Eigen::Vector3f::Ones();
    if (std::isfinite(point.distance)) colour = surface(point.normal, point.colour, open, lit);
    return point.veil + point.behind * colour;
  }

  float pixel() const { return pixel_; }

 private:
  Eigen::Vector3f surface(const Eigen::Vector3f& normal, const Eigen::Vector3f& colour, float open,
                          float lit) const {
    const float facing = std::max(0.0F, normal.dot(lamp_)), seen = std::max(0.0F, normal.dot(camera_.to_eye));
    const float shine =
        std::pow(std::max(0.0F, normal.dot((lamp_ + camera_.to_eye).normalized())), kGlossPower);
    return colour * (open * (kAmbient + kEye * seen) + kLamp * lit * facing) +
           Eigen::Vector3f::Constant(kGloss * lit * shine * open);
  }

  void gather_light(Point& point, const RayHit& hit, int column, int row) const {
    const auto cell =
        static_cast<std::uint32_t>((row & (kPattern - 1)) * kPattern + (column & (kPattern - 1)));
    const float lift = 1e-3F * light_.gap;
    const Eigen::Vector3f place = hit.place + lift * hit.normal;
    std::uint32_t free = 0;
    for (std::uint32_t k = 0; k < kAmbientRays; ++k) {
      const std::uint32_t number = cell * kAmbientRays + k;
      // A body keeps the less light away the farther it is: rays are of different length.
      const float reach = light_.gap * (static_cast<float>((number * 13) % 32) + 0.5F) / 32;
      if (!scene_.occluded(place, cosine_direction(hit.normal, even_sample(number + 1)), 0, reach)) ++free;
    }
    point.open = static_cast<float>(free) / kAmbientRays;
    const Eigen::Vector3f to_lamp = cone_direction(lamp_, kLampSize, even_sample(cell + 101));
    const bool dark = to_lamp.dot(hit.normal) <= 0 ||
                      scene_.occluded(place, to_lamp, 0, std::numeric_limits<float>::infinity());
    point.lit = dark ? 0.0F : 1.0F;
  }

  /// Adds up the surfaces in front of the point.
  void look_through(Point& point, const Eigen::Vector3f& origin, const Eigen::Vector3f& direction) const {
    constexpr int kMaxSurfaces = 24;
    float nearest = 0;
    for (int n = 0; n < kMaxSurfaces; ++n) {
      const RayHit hit = translucent_->first_hit(origin, direction, nearest);
      if (!(hit.distance < point.distance)) return;
      // Edges of a glassy body show: the flatter a ray meets it, the more it sees of it.
      const float seen = std::abs(hit.normal.dot(direction));
      const float opacity = opacity_ + (0.75F - opacity_) * std::pow(1 - seen, 4.0F);
      point.veil += point.behind * opacity * surface(hit.normal, colour_of(hit.colour), 1, 1);
      point.behind *= 1 - opacity;
      nearest = hit.distance + 1e-4F * light_.gap;
    }
  }

  const RayScene& scene_;
  const RayScene* translucent_;
  float opacity_;
  TracedCamera camera_;
  TracedLight light_;
  int width_, height_;
  float pixel_;
  Eigen::Vector3f lamp_;
};

/// The rays of one tile and those around it.
class Tile {
 public:
  Tile(const Tracer& tracer, int left, int top, int width, int height)
      : tracer_(tracer), left_(left), top_(top), columns_(width + 2 * kApron), points_() {
    points_.reserve(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(height + 2 * kApron));
    for (int row = -kApron; row < height + kApron; ++row)
      for (int column = -kApron; column < width + kApron; ++column)
        points_.push_back(tracer.point(left + column, top + row));
  }

  /// Colour of a ray, counted within the tile, its light smoothed over like neighbours.
  Eigen::Vector3f colour(int column, int row) const {
    const Point& own = at(column, row);
    if (!std::isfinite(own.distance)) return tracer_.shade(own, 1, 1);
    float open = 0, lit = 0, weights = 0;
    // The pattern repeats after four rays: each of its 16 counts once.
    for (int y = row - kApron; y < row - kApron + kPattern; ++y)
      for (int x = column - kApron; x < column - kApron + kPattern; ++x) {
        const Point& other = at(x, y);
        const float step = static_cast<float>(std::abs(x - column) + std::abs(y - row) + 1) * tracer_.pixel();
        const float alike = other.normal.dot(own.normal);
        if (alike < 0.8F || !(std::abs(other.distance - own.distance) < 4 * step)) continue;
        open += other.open;
        lit += other.lit;
        weights += 1;
      }
    return tracer_.shade(own, open / weights, lit / weights);
  }

 private:
  const Point& at(int column, int row) const {
    return points_[static_cast<std::size_t>((row + kApron) * columns_ + column + kApron)];
  }

  const Tracer& tracer_;
  int left_, top_, columns_;
  std::vector<Point> points_;
};

QRgb rgb_of(const Eigen::Vector3f& colour) {
  const auto byte = [](float value) {
    return static_cast<int>(std::lround(255 * std::clamp(value, 0.0F, 1.0F)));
  };
  return qRgb(byte(colour.x()), byte(colour.y()), byte(colour.z()));
}

}  // namespace

QImage trace_image(const RayScene& scene, const RayScene* translucent, float opacity,
                   const TracedCamera& camera, const TracedLight& light, int width, int height) {
  const Tracer tracer(scene, translucent, opacity, camera, light, width, height);
  QImage image(width, height, QImage::Format_RGB32);
  auto* pixels = reinterpret_cast<QRgb*>(image.bits());
  const int across = (width + kTile - 1) / kTile, down = (height + kTile - 1) / kTile;
  on_all_cores(across * down, [&](int number) {
    const int left = number % across * kTile, top = number / across * kTile;
    const int columns = std::min(kTile, width - left), rows = std::min(kTile, height - top);
    const Tile tile(tracer, kOversampling * left, kOversampling * top, kOversampling * columns,
                    kOversampling * rows);
    for (int row = 0; row < rows; ++row)
      for (int column = 0; column < columns; ++column) {
        Eigen::Vector3f sum = Eigen::Vector3f::Zero();
        for (int y = 0; y < kOversampling; ++y)
          for (int x = 0; x < kOversampling; ++x)
            sum += tile.colour(kOversampling * column + x, kOversampling * row + y).cwiseMin(1.0F);
        pixels[static_cast<std::size_t>(top + row) * static_cast<std::size_t>(width) +
               static_cast<std::size_t>(left + column)] = rgb_of(sum / (kOversampling * kOversampling));
      }
  });
  return image;
}

}  // namespace diefill::render
