#include "app/drawing.h"

#include "render/pictures.h"

namespace diefill::app {

std::vector<std::filesystem::path> draw(const std::filesystem::path& directory,
                                        const results::FillResult& result) {
  // Qt keeps both for the life of the program.
  static char name[] = "diefill";
  static char* arguments[] = {name, nullptr};
  static int count = 1;
  render::start_offscreen(count, arguments);
  return render::draw_all(directory, result);
}

}  // namespace diefill::app
