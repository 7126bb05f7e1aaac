#include <algorithm>
#include <cmath>
#include <optional>

#include "geometry/wall_spheres/cover_samples.h"
#include "geometry/wall_spheres/wall_holes.h"

namespace diefill::geometry {

namespace {

/// What was measured over a part of the surface.
struct Measured {
  double area = 0;
  double deviation_times_area = 0;
  double largest_deviation = 0;
  Eigen::Vector3d deviation_place = Eigen::Vector3d::Zero();
  double widest = 0;  ///< distance of the emptiest place from its nearest centres
  Eigen::Vector3d widest_place = Eigen::Vector3d::Zero();

  void add(const Measured& other) {
    area += other.area;
    deviation_times_area += other.deviation_times_area;
    if (other.largest_deviation > largest_deviation) {
      largest_deviation = other.largest_deviation;
      deviation_place = other.deviation_place;
    }
    if (other.widest > widest) {
      widest = other.widest;
      widest_place = other.widest_place;
    }
  }
};

/// Measures samples against the finished layout, for one thread.
class Surveyor {
 public:
  explicit Surveyor(const WallLayout& layout)
      : radius_(layout.offset().depth()), holes_(layout, kSampleStep * radius_) {}

  void measure(const SurfaceSample& sample, SampleKnown known, Measured& result) {
    measure_deviation(sample, result);
    measure_gap(sample, known, result);
  }

 private:
  void measure_deviation(const SurfaceSample& sample, Measured& result) {
    if (sample.area == 0) return;
    // Sharp corners may be far from every sphere; the search widens until it finds one.
    double limit = 1.6 * radius_;
    double distance = holes_.distance_to_nearest(sample.point, limit);
    while (distance >= limit && limit < kWidestSearch * radius_) {
      limit *= 2;
      distance = holes_.distance_to_nearest(sample.point, limit);
    }
    const double deviation = std::abs(distance - radius_);
    result.area += sample.area;
    result.deviation_times_area += sample.area * deviation;
    if (deviation > result.largest_deviation) {
      result.largest_deviation = deviation;
      result.deviation_place = sample.point;
    }
  }

  void measure_gap(const SurfaceSample& sample, SampleKnown known, Measured& result) {
    const double least = std::max(radius_, result.widest);
    if (holes_.covered(sample, least)) return;
    const bool straight = known == SampleKnown::kStraightBelow;
    const std::optional<Eigen::Vector3d> place = straight ? sample.at_depth(radius_) : holes_.below(sample);
    if (!place) return;
    const Hole hole = holes_.find(sample, *place, least);
    if (hole.distance <= result.widest) return;
    result.widest = hole.distance;
    result.widest_place = sample.point;
  }

  static constexpr double kWidestSearch = 32;
  double radius_;
  HoleFinder holes_;
};

}  // namespace

void measure_cover(const CoverTarget& target, const WallLayout& layout, SamplesKnown& known,
                   WallSpheres& spheres) {
  const double radius = layout.offset().depth();
  Measured all;
  const auto measure = [&](const Stretch& stretch) {
    Surveyor surveyor(layout);
    Measured here;
    here.widest = all.widest;  // of stretches taken: less need not be looked for
    std::vector<SampleKnown>& known_here = known[stretch.number];
    if (known_here.empty()) return here;  // no samples
    sample_stretch(target, stretch, radius, known_here,
                   [&](const SurfaceSample& sample, std::size_t, SampleKnown sample_known) {
                     surveyor.measure(sample, sample_known, here);
                   });
    return here;
  };
  StretchProgress progress(target, kMeasuringBegins, 1);
  work_and_take(target.stretches, measure, [&](const Measured& here) {
    progress.next();
    all.add(here);
  });
  spheres.mean_deviation = all.area > 0 ? all.deviation_times_area / all.area : 0;
  spheres.largest_deviation = all.largest_deviation;
  spheres.largest_deviation_place = all.deviation_place;
  spheres.largest_gap = 2 * std::max(0.0, all.widest - radius);
  spheres.largest_gap_place = all.widest_place;
}

}  // namespace diefill::geometry
