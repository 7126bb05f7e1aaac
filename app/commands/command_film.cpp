#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <thread>
#include <tuple>

#include "app/backup_notes.h"
#include "app/commands/commands.h"
#include "app/commands/film_command.h"
#include "app/commands/shared_options/view_options.h"
#include "app/exit_code.h"
#include "app/options/numbers.h"
#include "app/options/output_file.h"
#include "app/options/results_directories.h"
#include "app/output.h"
#include "app/pictures/drawing.h"
#include "app/pictures/film_file.h"
#include "app/pictures/film_frames.h"
#include "app/pictures/frame_folder.h"
#include "app/pictures/in_processes.h"
#include "app/pictures/picture_files.h"
#include "app/pictures/source_names.h"
#include "app/stop_signals.h"
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
  if (arguments.directories.size() > kMaxRunsInAFilm)
    throw process::SceneError("DIR: found " + std::to_string(arguments.directories.size()) +
                              " directories, at most " + std::to_string(kMaxRunsInAFilm) +
                              " go into one film");
  PictureRequest request;
  const std::vector<fs::path> directories(arguments.directories.begin(), arguments.directories.end());
  require_distinct("DIR", directories);
  const auto names = source_names(directories);
  for (std::size_t k = 0; k < names.size(); ++k)
    request.sources.push_back({names[k], results::read_results(directories[k]), ""});
  std::vector<ReadDirectory> read;
  for (std::size_t k = 0; k < names.size(); ++k) read.push_back({directories[k], &request.sources[k].result});
  require_no_copies("DIR", read);
  std::tie(request.lower, request.upper) = range_of(arguments.look);
  request.colour_by = arguments.look.colour_by;
  request.look = look_of(arguments.look);
  request.camera = camera_of(arguments.look.camera);
  request.width = arguments.look.width;
  return request;
}

/// DIR/film.mp4 or DIR/turntable.mp4, which reports of DIR show; of several runs DIR/film_compared.mp4.
fs::path film_path(const FilmArguments& arguments) {
  if (!arguments.out.empty()) {
    return arguments.out;
  }
  const fs::path folder = arguments.directories.front();
  if (arguments.directories.size() == 1) return folder / (arguments.turntable ? kTurntableFile : kFilmFile);
  return folder / (arguments.turntable ? "turntable_compared.mp4" : "film_compared.mp4");
}

fs::path frames_beside(const fs::path& film) {
  return fs::path(film).replace_extension("").concat("_frames");
}

/// The film's file. Throws process::SceneError where it is none, or where frames that stay would take the
/// place of other files.
OutputFile output_of(const FilmArguments& arguments) {
  const OutputFile output = {"--out", film_path(arguments), {".mp4"}};
  std::vector<fs::path> inputs;
  for (const auto& directory : arguments.directories) inputs.push_back(fs::path(directory) / "results.h5");
  require_output_file(output, inputs);
  if (arguments.keep_frames || !ffmpeg_is_there()) require_frames_alone(frames_beside(output.file));
  return output;
}

/// Whether there is a film of them now. Frames of which ffmpeg makes none are kept.
bool join_frames(FrameFolder& folder, const fs::path& film, const FilmArguments& arguments) {
  try {
    return write_film(folder.path(), film, arguments.frames_a_second);
  } catch (const std::runtime_error& error) {
    folder.keep(print_note);
    throw std::runtime_error(error.what() + std::string("; the frames are in ") + folder.path().string());
  }
}

void draw_frames(FilmFrames& frames, const PictureRequest& request, const fs::path& folder, std::size_t jobs,
                 const std::atomic<bool>& stop) {
  in_processes(frames.size(), jobs, stop, [&](std::size_t n) {
    // The drawing library's own threads would only wait for each other.
    if (jobs > 1) ::setenv("LP_NUM_THREADS", "1", 1);
    set_up_drawing();
    char name[32];
    std::snprintf(name, sizeof name, "%05zu.png", n);
    write_picture(request, folder / name, frames.frame(n));
  });
}

int film(const FilmArguments& arguments) {
  const OutputFile output = output_of(arguments);
  const PictureRequest request = request_of(arguments);
  const std::atomic<bool>& stop = install_stop_handlers();
  const DirectoryToFill filled(output.file.has_parent_path() ? output.file.parent_path() : fs::path("."));
  const auto cores = std::max(1U, std::thread::hardware_concurrency());
  const std::size_t jobs = arguments.jobs > 0 ? static_cast<std::size_t>(arguments.jobs) : cores;
  try {
    write_output([&] {
      FilmFrames frames(request, arguments.turntable);
      FrameFolder folder(frames_beside(output.file));
      draw_frames(frames, request, folder.path(), jobs, stop);
      if (join_frames(folder, output.file, arguments)) {
        std::printf("%s: %zu frames\n", output.file.string().c_str(), frames.size());
        if (!arguments.keep_frames) return;
      }
      folder.keep(print_note);
      std::printf("%s: %zu PNG files\n", folder.path().string().c_str(), frames.size());
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
  const std::string output = results::contents_or_nothing(log).value_or("");
  if (*program.ended() != kDone) throw std::runtime_error("film " + directory.string() + ": " + output);
  fs::remove(log);
  std::printf("%s", output.c_str());
}

void add_film(CLI::App& program, Action& chosen) {
  auto* command = program.add_subcommand("film", "Make a film of a run, or of up to four runs in one frame");
  auto arguments = std::make_shared<FilmArguments>();
  arguments->look.width = kFilmWidth;
  command->add_option("DIR", arguments->directories, "results directories of runs; one camera for all")
      ->required();
  command->add_flag("--turntable", arguments->turntable,
                    "the final state from all sides instead of the filling over time");
  command->add_option("--out", arguments->out,
                      "film (default: film.mp4 or turntable.mp4 in DIR, where its report finds it)");
  command->add_option("--frames-per-second", arguments->frames_a_second, "speed of the film")
      ->check(whole_number(1, 120))
      ->capture_default_str();
  command->add_option("--jobs", arguments->jobs, "frames drawn at a time (default: one per core)")
      ->check(whole_number(1, 1024));
  command->add_flag("--keep-frames", arguments->keep_frames, "keep the frames as PNG files beside the film");
  add_view_options(*command, arguments->look);
  command->footer(
      "The filling over time needs measure.snapshot_interval in the scene. Without ffmpeg the frames are "
      "kept as\nPNG files. Where a shoe crosses the cavity, the view stays close to the cavity.\n"
      "Examples:\n"
      "  diefill film out/narrow_ring\n"
      "  diefill film out/narrow_ring --turntable --tools translucent\n"
      "  diefill film out/slow out/fast --colour-by speed --camera corner --out compared.mp4");
  command->callback([arguments, &chosen] { chosen = [arguments] { return film(*arguments); }; });
}

}  // namespace diefill::app
