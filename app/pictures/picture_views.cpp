// Pictures that are shaded views, and films of them.
#include <cstdio>

#include "app/output.h"
#include "app/pictures/film_file.h"
#include "app/pictures/film_frames.h"
#include "app/pictures/grain_colours.h"
#include "app/pictures/picture_files.h"
#include "process/measure/earlier_instant.h"
#include "render/scene3d/snapshot.h"

namespace diefill::app {
namespace {

render::ViewOptions options_of(const PictureRequest& request) {
  render::ViewOptions options;
  options.lower = request.lower;
  options.upper = request.upper;
  options.camera = request.camera;
  options.look = request.look;
  options.pixels = pixels_of(request);
  return options;
}

}  // namespace

Pictures make_view(const PictureRequest& request) {
  Pictures written;
  render::ViewOptions common = options_of(request);
  // The solid fraction has the scale of the run's own pictures.
  if (request.sources.size() > 1 || request.colour_by == "solid-fraction")
    fix_scale(common, request.colour_by, results_of(request));
  for (const auto& source : request.sources) {
    const results::FillResult shown =
        request.to ? process::result_at(source.result, *request.to) : source.result;
    render::ViewOptions options = common;
    colour_grains(options, request.colour_by, shown, source.result);
    written.push_back(write_picture(request, file_of(request, "view", source),
                                    render::compose_snapshot(shown, options).image));
  }
  return written;
}

Pictures make_frames(const PictureRequest& request) {
  Pictures written;
  const auto all = results_of(request);
  for (const auto& source : request.sources) {
    const auto& result = source.result;
    if (result.instants.empty()) process::result_at(result, -1);  // says what is missing
    render::ViewOptions options = options_of(request);
    fix_scale(options, request.colour_by, all);
    const bool measured = request.colour_by == "solid-fraction";
    options.view = view_of_film(result, request.camera);
    const auto folder = request.out / file_of(request, "frames", source).stem();
    const DirectoryToFill filled(folder);
    for (std::size_t n = 0; n < result.instants.size(); ++n) {
      const auto shown = process::film_frame_at(result, result.instants[n].time, measured);
      colour_grains(options, request.colour_by, shown, result);
      char name[32];
      std::snprintf(name, sizeof name, "%05zu.png", n);
      written.push_back(
          write_picture(request, folder / name, render::compose_snapshot(shown, options).image));
    }
    const auto film = request.out / file_of(request, "film", source).stem().concat(".mp4");
    if (write_film(folder, film)) written.push_back(film);
  }
  return written;
}

}  // namespace diefill::app
