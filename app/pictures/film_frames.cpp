#include "app/pictures/film_frames.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "app/pictures/grain_colours.h"
#include "app/pictures/picture_files.h"
#include "process/measure/earlier_instant.h"
#include "render/fields/pictures.h"
#include "render/style/picture_bytes.h"

namespace diefill::app {
namespace {

/// The times at which any source has an instant, rising, each once; the end comes last.
std::vector<double> times_of(const std::vector<PictureSource>& sources) {
  std::vector<double> times;
  for (const auto& source : sources) {
    for (const auto& instant : source.result.instants) times.push_back(instant.time);
    times.push_back(source.result.powder.time);
  }
  std::sort(times.begin(), times.end());
  const double same = times.empty() ? 0 : 1e-6 * times.back();
  times.erase(std::unique(times.begin(), times.end(), [&](double a, double b) { return b - a <= same; }),
              times.end());
  return times;
}

/// The source at the time, or at its own first instant or end where that lies beyond them.
results::FillResult at_time(const results::FillResult& result, double time, bool measured) {
  const double first = result.instants.empty() ? result.powder.time : result.instants.front().time;
  return process::film_frame_at(result, std::clamp(time, first, result.powder.time), measured);
}

/// What the first instant and the end show.
render::ViewChoice whole_view(const results::FillResult& result, const render::Camera& camera) {
  const double aspect = render::scene_aspect(result);
  const auto first = render::choose_view(at_time(result, 0, false), aspect, camera),
             end = render::choose_view(result, aspect, camera);
  if (first.width <= 0) return end;
  return end.width > 0 ? render::united(first, end) : first;
}

/// Shows what is to be seen of all sources, so that all frames are to one scale.
render::ViewChoice common_view(const PictureRequest& request, bool turntable) {
  render::ViewChoice common;
  for (const auto& source : request.sources) {
    const auto view =
        turntable ? whole_view(source.result, request.camera) : view_of_film(source.result, request.camera);
    if (view.width > 0) common = common.width > 0 ? render::united(common, view) : view;
  }
  return common;
}

}  // namespace

render::ViewChoice view_of_film(const results::FillResult& result, const render::Camera& camera) {
  const auto passage = render::view_of_passage(result, render::scene_aspect(result), camera);
  return passage ? *passage : whole_view(result, camera);
}

FilmFrames::FilmFrames(const PictureRequest& request, bool turntable)
    : request_(request), turntable_(turntable), times_(times_of(request.sources)) {
  for (const auto& source : request.sources)
    if (!turntable && source.result.instants.empty())
      process::result_at(source.result, -1);  // says what is missing
}

/// The scale and the view that all frames share.
void FilmFrames::prepare() {
  if (std::exchange(prepared_, true)) return;
  const PictureRequest& request = request_;
  const auto results = results_of(request);
  common_.lower = request.lower;
  common_.upper = request.upper;
  common_.look = request.look;
  common_.camera = request.camera;
  // Of several, one pixel a layout point is enough.
  common_.pixels = request.sources.size() > 1 ? 1 : pixels_of(request);
  fix_scale(common_, request.colour_by, results);
  view_ = common_view(request, turntable_);
}

render::ViewOptions FilmFrames::options_of(const results::FillResult& shown, std::size_t n) const {
  render::ViewOptions options = common_;
  options.view = view_;
  if (!turntable_) return options;
  options.camera.azimuth += 2 * std::numbers::pi * static_cast<double>(n) / kTurntableFrames;
  options.view = render::choose_view(shown, render::scene_aspect(shown), options.camera);
  options.view->target = view_.target;
  options.view->width = view_.width;
  options.view->height = view_.height;
  return options;
}

QImage FilmFrames::of_source(const PictureSource& source, std::size_t n) const {
  const bool measured = request_.colour_by == "solid-fraction";
  auto shown = turntable_ ? source.result : at_time(source.result, times_[n], measured);
  if (request_.sources.size() > 1) shown.strategy = source.name;
  render::ViewOptions options = options_of(shown, n);
  colour_grains(options, request_.colour_by, shown, source.result);
  return render::compose_snapshot(shown, options).image;
}

QImage FilmFrames::frame(std::size_t n) {
  prepare();
  std::vector<QImage> parts;
  for (const auto& source : request_.sources) parts.push_back(of_source(source, n));
  return parts.size() == 1 ? parts.front() : render::side_by_side(parts);
}

}  // namespace diefill::app
