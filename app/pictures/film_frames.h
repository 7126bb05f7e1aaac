// The frames of a film: powder and tools of one run or several at an instant, in one picture.
#pragma once

#include <string>
#include <vector>

#include "app/pictures/picture_kinds.h"
#include "render/scene3d/snapshot.h"

namespace diefill::app {

/// Most runs in one frame: two above two.
inline constexpr std::size_t kMaxRunsInAFilm = 4;

/// One view for all instants of a result: close to the cavity where a shoe crosses it; otherwise what the
/// first instant and the end show.
render::ViewChoice view_of_film(const results::FillResult& result, const render::Camera& camera);

/// What the frames of a film have in common. The sources must outlive it. Draws nothing before the first
/// frame, so that frames can be drawn in processes of their own.
class FilmFrames {
 public:
  /// `request`: sources, colours, look, camera, width in pixels of a whole frame. `turntable`: the end from
  /// all sides instead of the instants. Throws std::invalid_argument where there are no instants to show.
  FilmFrames(const PictureRequest& request, bool turntable);

  std::size_t size() const { return turntable_ ? kTurntableFrames : times_.size(); }
  /// set_up_drawing() must have been called. Throws what colour_grains throws.
  QImage frame(std::size_t n);

 private:
  static constexpr std::size_t kTurntableFrames = 120;
  void prepare();
  QImage of_source(const PictureSource& source, std::size_t n) const;
  render::ViewOptions options_of(const results::FillResult& shown, std::size_t n) const;

  const PictureRequest& request_;
  bool turntable_, prepared_ = false;
  std::vector<double> times_;  ///< s
  render::ViewOptions common_;
  render::ViewChoice view_;
};

}  // namespace diefill::app
