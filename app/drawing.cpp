#include "app/drawing.h"

#include "render/comparison_picture.h"
#include "render/pictures.h"

namespace diefill::app {

void set_up_drawing() {
  // Qt keeps both for the life of the program.
  static char name[] = "diefill";
  static char* arguments[] = {name, nullptr};
  static int count = 1;
  render::start_offscreen(count, arguments);
}

std::vector<std::filesystem::path> draw(const std::filesystem::path& directory,
                                        const results::FillResult& result) {
  set_up_drawing();
  return render::draw_all(directory, result);
}

std::vector<std::filesystem::path> draw(const std::filesystem::path& directory,
                                        const results::Comparison& comparison) {
  std::vector<render::ComparedField> fields;
  for (std::size_t k = 0; k < comparison.variants.size(); ++k)
    if (!comparison.fields[k].value.empty()) fields.push_back({comparison.variants[k], comparison.fields[k]});
  if (fields.empty()) return {};
  set_up_drawing();
  const auto png = directory / "comparison.png";
  render::draw_comparison(png, fields, comparison.title);
  return {png};
}

}  // namespace diefill::app
