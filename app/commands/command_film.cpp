#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <stdexcept>
#include <thread>

#include "app/commands/film_command.h"
#include "app/commands/view_options.h"
#include "app/exit_code.h"
#include "app/output.h"
#include "app/pictures/drawing.h"
#include "app/pictures/film_file.h"
#include "app/pictures/film_frames.h"
#include "app/pictures/in_processes.h"
#include "app/pictures/picture_files.h"
#include "app/pictures/source_names.h"
#include "process/compare/child_process.h"
#include "process/input/scene_error.h"
#include "process/results/storage/file_contents.h"
#include "process/results/storage/result_file.h"

namespace diefill::app {

namespace {

namespace fs = std::filesystem;

constexpr int kFilmWidth = 1280;

struct FilmArguments {
  std::vector<std::string> directories;
  std::string out;
  ViewArguments look;
  int jobs = 0, frames_a_second = 20;
  bool turntable = false, keep_frames = false;
};

PictureRequest request_of(const FilmArguments& arguments) {
  if (arguments.directories.size() > kMostRunsInAFilm)
    throw process::SceneError("DIR: found " + std::to_string(arguments.directories.size()) +
                              " directories, at most " + std::to_string(kMostRunsInAFilm) +
                              " go into one film");
  PictureRequest request;
  const auto names = source_names({arguments.directories.begin(), arguments.directories.end()});
  for (std::size_t k = 0; k < names.size(); ++k)
    request.sources.push_back({names[k], results::read_results(arguments.directories[k]), ""});
  const bool given = !arguments.look.range.empty();
  request.lower = given ? arguments.look.range[0] : std::nan("");
  request.upper = given ? arguments.look.range[1] : std::nan("");
  if (request.lower >= request.upper)
    throw process::SceneError("--range: the first number must be less than the second");
  request.colour_by = arguments.look.colour_by;
  request.look = look_of(arguments.look);
  request.camera = camera_of(arguments.look.camera);
  request.width = arguments.look.width;
  return request;
}

/// DIR/film.mp4 or DIR/turntable.mp4, which reports of DIR show; of several runs DIR/film_compared.mp4.
fs::path film_path(const FilmArguments& arguments) {
  if (!arguments.out.empty()) {
    if (fs::path(arguments.out).extension() != ".mp4")
      throw process::SceneError("--out: found \"" + arguments.out + "\", allowed: a file that ends in .mp4");
    return arguments.out;
  }
  const fs::path folder = arguments.directories.front();
  if (arguments.directories.size() == 1) return folder / (arguments.turntable ? kTurntableFile : kFilmFile);
  return folder / (arguments.turntable ? "turntable_compared.mp4" : "film_compared.mp4");
}

void draw_frames(FilmFrames& frames, const PictureRequest& request, const fs::path& folder,
                 std::size_t jobs) {
  fs::create_directories(folder);
  in_processes(frames.size(), jobs, [&](std::size_t n) {
    // The drawing library's own threads would only wait for each other.
    if (jobs > 1) ::setenv("LP_NUM_THREADS", "1", 1);
    set_up_drawing();
    char name[32];
    std::snprintf(name, sizeof name, "%05zu.png", n);
    write_picture(request, folder / name, frames.frame(n));
  });
}

int film(const FilmArguments& arguments) {
  const fs::path file = film_path(arguments);
  const PictureRequest request = request_of(arguments);
  make_output_directory(file.parent_path().empty() ? fs::path(".") : file.parent_path());
  const fs::path folder = fs::path(file).replace_extension("").concat("_frames");
  const auto cores = std::max(1U, std::thread::hardware_concurrency());
  const std::size_t jobs = arguments.jobs > 0 ? static_cast<std::size_t>(arguments.jobs) : cores;
  try {
    write_output([&] {
      FilmFrames frames(request, arguments.turntable);
      fs::remove_all(folder);
      draw_frames(frames, request, folder, jobs);
      const bool written = write_film(folder, file, arguments.frames_a_second);
      if (written) std::printf("%s: %zu frames\n", file.string().c_str(), frames.size());
      if (written && !arguments.keep_frames)
        fs::remove_all(folder);
      else
        std::printf("%s: %zu PNG files\n", folder.string().c_str(), frames.size());
    });
  } catch (const std::invalid_argument& error) {
    throw process::SceneError(error.what());
  }
  return kDone;
}

}  // namespace

void make_film(const fs::path& directory, const fs::path& to, const std::string& colour_by) {
  const fs::path log = to.string() + ".log";
  fs::remove(log);
  process::ChildProcess program({fs::read_symlink("/proc/self/exe").string(), "film", directory.string(),
                                 "--out", to.string(), "--colour-by", colour_by},
                                log);
  while (!program.ended()) std::this_thread::sleep_for(std::chrono::milliseconds(50));
  const std::string said = results::contents_or_nothing(log).value_or("");
  if (*program.ended() != kDone) throw std::runtime_error("film " + directory.string() + ": " + said);
  fs::remove(log);
  std::printf("%s", said.c_str());
}

void add_film(CLI::App& program, Action& chosen) {
  auto* command = program.add_subcommand("film", "Make a film of a run, or of up to four runs in one frame");
  auto arguments = std::make_shared<FilmArguments>();
  arguments->look.width = kFilmWidth;
  command->add_option("DIR", arguments->directories, "results directories of runs; one camera for all")
      ->required();
  command->add_flag("--turntable", arguments->turntable,
                    "the end from all sides instead of the filling over time");
  command->add_option("--out", arguments->out,
                      "film (default: film.mp4 or turntable.mp4 in DIR, where its report finds it)");
  command->add_option("--frames-per-second", arguments->frames_a_second, "speed of the film")
      ->check(CLI::Range(1, 120))
      ->capture_default_str();
  command->add_option("--jobs", arguments->jobs, "frames drawn at a time (default: one a core)")
      ->check(CLI::Range(1, 1024));
  command->add_flag("--keep-frames", arguments->keep_frames, "keep the frames as PNG files beside the film");
  add_view_options(*command, arguments->look);
  command->footer(
      "The filling over time needs measure.snapshot_interval in the scene. Without ffmpeg the frames are "
      "kept as "
      "PNG files.\n"
      "Examples:\n"
      "  diefill film out/narrow_ring\n"
      "  diefill film out/narrow_ring --turntable --tools translucent\n"
      "  diefill film out/slow out/fast --colour-by speed --camera corner --out compared.mp4");
  command->callback([arguments, &chosen] { chosen = [arguments] { return film(*arguments); }; });
}

}  // namespace diefill::app
