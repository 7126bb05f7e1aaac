#include "app/pictures/film_file.h"

#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>

#include "process/input/shell_word.h"

namespace diefill::app {

bool ffmpeg_is_there() {
  return std::system("command -v ffmpeg > /dev/null 2>&1") == 0;
}

bool write_film(const std::filesystem::path& frames, const std::filesystem::path& film, int frames_a_second) {
  if (!ffmpeg_is_there()) {
    std::fprintf(stderr,
                 "diefill: no film %s: ffmpeg is not installed (apt-get install ffmpeg); the frames stay as "
                 "PNG files\n",
                 film.filename().string().c_str());
    return false;
  }
  // Among the frames, with which it goes where this process is killed.
  const auto unfinished = frames / (film.stem().string() + "." + std::to_string(::getpid()) + ".tmp.mp4");
  const std::string command =
      "ffmpeg -loglevel error -y -framerate " + std::to_string(frames_a_second) + " -i " +
      process::shell_word((frames / "%05d.png").string()) +
      " -vf 'pad=ceil(iw/2)*2:ceil(ih/2)*2:color=white' -c:v libx264 -pix_fmt yuv420p -movflags +faststart " +
      process::shell_word(unfinished.string());
  if (std::system(command.c_str()) != 0) {
    std::filesystem::remove(unfinished);
    throw std::runtime_error("ffmpeg could not make " + film.string());
  }
  std::filesystem::rename(unfinished, film);
  return true;
}

}  // namespace diefill::app
