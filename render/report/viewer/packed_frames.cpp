#include "render/report/viewer/packed_frames.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace diefill::render::report {
namespace {

using Words = std::vector<std::uint16_t>;

constexpr double kMillimetre = 1e3;
constexpr double kSteps = 65534;  // of a coordinate
constexpr std::uint16_t kAbsent = 65535;
constexpr double kSlowest = 1e-5;    // m/s: slower counts as rest
constexpr double kSpeedStep = 1e-2;  // of the natural logarithm
constexpr double kFractionSteps = 5000;
constexpr double kTurnSteps = 127;
constexpr double kStepOverRadius = 0.03;  // finer than a screen shows; digits add to the file

/// One instant, seen the same way whether kept or the end.
struct Frame {
  double time = 0;
  const std::vector<std::uint64_t>* id = nullptr;
  const std::vector<Eigen::Vector3d>*position = nullptr, *velocity = nullptr;
  const std::vector<Eigen::Vector4d>* orientation = nullptr;
  std::vector<double> fraction;  ///< empty: not measured
  const results::Instant* instant = nullptr;
};

std::vector<double> fractions_at_end(const results::GrainSolidFraction& measured) {
  std::vector<double> values = measured.solid_fraction;
  for (std::size_t k = 0; k < values.size(); ++k)
    if (measured.open[k] != 0) values[k] = std::nan("");
  return values;
}

std::vector<Frame> frames_of(const ViewedRun& run, const std::vector<std::size_t>& instants) {
  std::vector<Frame> frames;
  const auto& result = *run.result;
  for (const std::size_t n : instants) {
    const auto& kept = result.instants[n];
    frames.push_back({kept.time, &kept.id, &kept.position, &kept.velocity, &kept.orientation, {}, &kept});
    if (run.extras == nullptr) continue;
    for (const auto& measured : run.extras->fractions)
      if (measured.instant == n) frames.back().fraction = measured.solid_fraction;
  }
  const auto& end = result.powder;
  frames.push_back({end.time, &end.id, &end.position, &end.velocity, &end.orientation,
                    fractions_at_end(result.solid_fraction), nullptr});
  return frames;
}

/// Place of every shown grain in the frame, or -1.
std::vector<std::ptrdiff_t> places_in(const Frame& frame, const ShownGrains& shown) {
  std::vector<std::ptrdiff_t> place(shown.id.size(), -1);
  for (std::size_t k = 0; k < frame.id->size(); ++k) {
    const auto found = std::lower_bound(shown.id.begin(), shown.id.end(), (*frame.id)[k]);
    if (found != shown.id.end() && *found == (*frame.id)[k])
      place[static_cast<std::size_t>(found - shown.id.begin())] = static_cast<std::ptrdiff_t>(k);
  }
  return place;
}

std::uint16_t rounded(double value) {
  return static_cast<std::uint16_t>(std::lround(std::clamp(value, 0.0, kSteps)));
}

std::uint16_t speed_word(double speed) {
  return speed > kSlowest ? rounded(1 + std::log(speed / kSlowest) / kSpeedStep) : std::uint16_t{0};
}

std::uint16_t fraction_word(double fraction) {
  return std::isfinite(fraction) ? rounded(1 + kFractionSteps * fraction) : std::uint16_t{0};
}

/// The numbers of one frame, component after component.
struct FrameWords {
  Words position, speed, fraction;
  std::vector<std::uint8_t> turn;
};

class FramePacker {
 public:
  /// `smallest_radius`: mm, of the spheres.
  FramePacker(const std::vector<Frame>& frames, const ShownGrains& shown, double smallest_radius)
      : shown_(shown) {
    for (const Frame& frame : frames)
      for (const auto& place : *frame.position)
        if (place.allFinite()) box_.extend(kMillimetre * place);
    if (box_.isEmpty()) box_.extend(Eigen::Vector3d(0, 0, 0));
    step_ = std::max({box_.sizes().maxCoeff() / kSteps, kStepOverRadius * smallest_radius, 1e-6});
  }

  FrameWords words_of(const Frame& frame) const {
    const std::size_t n = shown_.id.size();
    FrameWords words{Words(3 * n, kAbsent), Words(n, 0), Words(n, 0), std::vector<std::uint8_t>(4 * n, 0)};
    const auto places = places_in(frame, shown_);
    for (std::size_t g = 0; g < n; ++g) {
      if (places[g] < 0) continue;
      const auto k = static_cast<std::size_t>(places[g]);
      const Eigen::Vector3d at = (kMillimetre * (*frame.position)[k] - box_.min()) / step_;
      const Eigen::Vector4d turn = (*frame.orientation)[k] * ((*frame.orientation)[k][0] < 0 ? -1.0 : 1.0);
      for (std::size_t c = 0; c < 3; ++c)
        words.position[c * n + g] = rounded(at[static_cast<Eigen::Index>(c)]);
      for (std::size_t c = 0; c < 4; ++c)
        words.turn[c * n + g] =
            static_cast<std::uint8_t>(std::lround(kTurnSteps * (1 + turn[static_cast<Eigen::Index>(c)])));
      words.speed[g] = frame.velocity->empty() ? std::uint16_t{0} : speed_word((*frame.velocity)[k].norm());
      if (k < frame.fraction.size()) words.fraction[g] = fraction_word(frame.fraction[k]);
    }
    return words;
  }

  QJsonObject box() const {
    const auto& low = box_.min();
    return {{"lower", QJsonArray{low.x(), low.y(), low.z()}}, {"step", step_}};
  }

 private:
  const ShownGrains& shown_;
  Eigen::AlignedBox3d box_;  // mm
  double step_ = 1;          // mm
};

/// What has changed since `before`, with wrap-around; `before` becomes `words`.
template <class Word>
std::vector<Word> change(const std::vector<Word>& words, std::vector<Word>& before) {
  before.resize(words.size(), 0);
  std::vector<Word> difference(words.size());
  for (std::size_t k = 0; k < words.size(); ++k) difference[k] = static_cast<Word>(words[k] - before[k]);
  before = words;
  return difference;
}

double smallest_radius(const results::PowderState& powder) {
  double smallest = powder.sphere_radius;
  for (const auto& radii : {powder.sphere_radii, powder.kinds.sphere_radii})
    for (const double radius : radii) smallest = std::min(smallest, radius);
  return smallest;
}

QJsonArray poses_of(const Frame& frame, std::size_t tools) {
  QJsonArray poses;
  for (std::size_t n = 0; n < tools; ++n) {
    QJsonArray pose{1, 0, 0, 0, 0, 0, 0};
    if (frame.instant != nullptr && n < frame.instant->tool_orientation.size()) {
      const auto& turn = frame.instant->tool_orientation[n];
      const Eigen::Vector3d way = kMillimetre * frame.instant->tool_displacement[n];
      pose = {turn[0], turn[1], turn[2], turn[3], way.x(), way.y(), way.z()};
    }
    poses.append(pose);
  }
  return poses;
}

}  // namespace

QJsonObject pack_frames(PackedBytes& bytes, const ViewedRun& run, const std::vector<std::size_t>& instants,
                        const ShownGrains& shown) {
  const auto frames = frames_of(run, instants);
  const FramePacker packer(frames, shown, kMillimetre * smallest_radius(run.result->powder));
  QJsonArray list;
  FrameWords before;
  for (std::size_t n = 0; n < frames.size(); ++n) {
    const std::string number = std::to_string(n);
    const FrameWords words = packer.words_of(frames[n]);
    bytes.add("position" + number, change(words.position, before.position));
    bytes.add("turn" + number, change(words.turn, before.turn));
    bytes.add("speed" + number, words.speed);
    bytes.add("fraction" + number, words.fraction);
    list.append(
        QJsonObject{{"time", frames[n].time}, {"poses", poses_of(frames[n], run.result->tools.size())}});
  }
  return {{"box", packer.box()}, {"frames", list}};
}

}  // namespace diefill::render::report
