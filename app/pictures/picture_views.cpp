// Pictures that are shaded views, and films of them.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <set>
#include <stdexcept>

#include "app/pictures/picture_files.h"
#include "process/input/scene_error.h"
#include "process/measure/coordination.h"
#include "process/measure/earlier_instant.h"
#include "render/scene3d/snapshot.h"

namespace diefill::app {
namespace {

constexpr int kFramesASecond = 20;

/// Height of every grain, mm, at the first instant kept, by its identity: the layer it comes from.
std::vector<double> origin_layers(const results::FillResult& result, const results::FillResult& whole) {
  if (whole.instants.empty()) process::result_at(whole, -1);  // says what is missing
  const auto& first = whole.instants.front();
  std::vector<std::pair<std::uint64_t, double>> heights;
  for (std::size_t k = 0; k < first.id.size(); ++k)
    heights.emplace_back(first.id[k], 1e3 * first.position[k].z());
  std::sort(heights.begin(), heights.end());
  std::vector<double> values;
  for (const auto id : result.powder.id) {
    const auto found = std::lower_bound(heights.begin(), heights.end(),
                                        std::pair(id, -std::numeric_limits<double>::infinity()));
    values.push_back(found != heights.end() && found->first == id ? found->second : std::nan(""));
  }
  return values;
}

/// The powder of every grain as a number, and what the numbers mean.
void colour_by_powder(render::ViewOptions& options, const results::PowderState& powder) {
  const std::vector<std::string>& names = powder.kinds.material;
  const std::set<std::string> different(names.begin(), names.end());
  if (different.size() < 2)
    throw process::SceneError(
        "--colour-by powder: the result holds one powder only; choose another colour, such as diameter");
  const std::vector<std::string> sorted(different.begin(), different.end());
  std::vector<double> numbers;  // of kinds
  for (const auto& name : names) {
    const auto place = std::lower_bound(sorted.begin(), sorted.end(), name);
    numbers.push_back(static_cast<double>(1 + (place - sorted.begin())));
  }
  for (std::size_t n = 0; n < sorted.size(); ++n)
    options.quantity += (n == 0 ? "powder: " : ", ") + std::to_string(n + 1) + " " + sorted[n];
  for (const auto kind : powder.kind) options.values.push_back(numbers[kind]);
}

/// Colours of `result`, which is `whole` at some instant.
void colour(render::ViewOptions& options, const std::string& by, const results::FillResult& result,
            const results::FillResult& whole) {
  options.values.clear();
  if (by == "solid-fraction") return;
  options.grey_means = "no value";
  if (by == "speed") {
    options.quantity = "speed";
    options.unit = "m/s";
    for (const auto& velocity : result.powder.velocity) options.values.push_back(velocity.norm());
  } else if (by == "powder") {
    options.quantity.clear();
    colour_by_powder(options, result.powder);
  } else if (by == "diameter") {
    options.quantity = "grain diameter";
    options.unit = "mm";
    for (std::size_t k = 0; k < result.powder.position.size(); ++k)
      options.values.push_back(1e3 * result.powder.diameter_of(k));
  } else if (by == "coordination") {
    options.quantity = "grains touched";
    for (const int number : process::coordination_numbers(result.powder)) options.values.push_back(number);
  } else {
    options.quantity = "height at the first stored instant";
    options.unit = "mm";
    options.values = origin_layers(result, whole);
  }
}

render::ViewOptions options_of(const PictureRequest& request) {
  render::ViewOptions options;
  options.lower = request.lower;
  options.upper = request.upper;
  options.camera = request.camera;
  options.look = request.look;
  options.pixels = pixels_of(request);
  return options;
}

/// One scale for all frames: from 0 to what all but a few grains reach.
void fix_scale(render::ViewOptions& options, const PictureRequest& request,
               const results::FillResult& result) {
  if (request.colour_by != "speed" || !std::isnan(options.upper)) return;
  std::vector<double> speeds;
  for (const auto& instant : result.instants)
    for (const auto& velocity : instant.velocity) speeds.push_back(velocity.norm());
  options.lower = 0;
  options.upper = render::robust_range(speeds).upper;
}

/// A picture's path as one argument of a shell command.
std::string quoted(const std::filesystem::path& path) {
  std::string text = "'";
  for (const char letter : path.string())
    text += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
  return text + "'";
}

void make_film(const std::filesystem::path& frames, const std::filesystem::path& film, Pictures& written) {
  if (std::system("command -v ffmpeg > /dev/null 2>&1") != 0) {
    std::fprintf(stderr,
                 "diefill: no film: ffmpeg is not installed (apt-get install ffmpeg); the frames are in %s\n",
                 frames.string().c_str());
    return;
  }
  const std::string command =
      "ffmpeg -loglevel error -y -framerate " + std::to_string(kFramesASecond) + " -i " +
      quoted(frames / "%05d.png") +
      " -vf 'pad=ceil(iw/2)*2:ceil(ih/2)*2:color=white' -c:v libx264 -pix_fmt yuv420p " + quoted(film);
  if (std::system(command.c_str()) != 0)
    throw std::runtime_error("ffmpeg could not make " + film.string() + "; the frames are in " +
                             frames.string());
  written.push_back(film);
}

}  // namespace

Pictures make_view(const PictureRequest& request) {
  Pictures written;
  for (const auto& source : request.sources) {
    const results::FillResult shown =
        request.to ? process::result_at(source.result, *request.to) : source.result;
    render::ViewOptions options = options_of(request);
    colour(options, request.colour_by, shown, source.result);
    written.push_back(write_picture(request, file_of(request, "view", source),
                                    render::compose_snapshot(shown, options).image));
  }
  return written;
}

Pictures make_frames(const PictureRequest& request) {
  Pictures written;
  for (const auto& source : request.sources) {
    const auto& result = source.result;
    if (result.instants.empty()) process::result_at(result, -1);  // says what is missing
    render::ViewOptions options = options_of(request);
    fix_scale(options, request, result);
    const bool measured = request.colour_by == "solid-fraction";
    const double aspect = render::scene_aspect(result);
    options.view = render::choose_view(process::result_at(result, result.instants.front().time, false),
                                       aspect, request.camera);
    const auto last = render::choose_view(result, aspect, request.camera);
    if (last.width > options.view->width) options.view = last;
    const auto folder = request.out / file_of(request, "frames", source).stem();
    std::filesystem::create_directories(folder);
    for (std::size_t n = 0; n < result.instants.size(); ++n) {
      const auto shown = process::result_at(result, result.instants[n].time, measured);
      colour(options, request.colour_by, shown, result);
      char name[32];
      std::snprintf(name, sizeof name, "%05zu.png", n);
      written.push_back(
          write_picture(request, folder / name, render::compose_snapshot(shown, options).image));
    }
    make_film(folder, request.out / file_of(request, "film", source).stem().concat(".mp4"), written);
  }
  return written;
}

}  // namespace diefill::app
