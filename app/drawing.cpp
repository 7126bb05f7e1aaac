#include "app/drawing.h"

#include "render/pictures.h"

namespace diefill::app {

void start_drawing() {
  // Qt keeps both for the life of the program.
  static char name[] = "diefill";
  static char* arguments[] = {name, nullptr};
  static int count = 1;
  render::start_offscreen(count, arguments);
}

std::vector<std::filesystem::path> draw(const std::filesystem::path& directory,
                                        const results::FillResult& result) {
  start_drawing();
  return render::draw_all(directory, result);
}

}  // namespace diefill::app
