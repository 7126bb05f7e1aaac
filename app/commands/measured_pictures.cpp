#include "app/commands/measured_pictures.h"

#include <cstdio>

#include "app/exit_code.h"
#include "app/output.h"
#include "app/pictures/drawing.h"
#include "process/input/scene_error.h"
#include "process/results/storage/atomic_file.h"
#include "process/results/studies/measured_files.h"
#include "render/report/sections/measured_section.h"

namespace diefill::app {
namespace {

/// A file of the user's may have the name of one of the tables.
void refuse_foreign_files(const PictureRequest& request, const std::vector<process::MeasuredFile>& measured) {
  for (const auto& file : measured)
    if (const auto foreign = results::foreign_measured_file(request.out, file.file.stem().string()))
      throw process::SceneError(
          "--measured: found \"" + file.file.string() + "\", whose comparison would replace " +
          foreign->string() +
          ", which is not of an earlier comparison; rename that file, or choose another "
          "directory with --out");
}

}  // namespace

int draw_against_measured(const PictureRequest& request, const std::vector<process::MeasuredFile>& measured) {
  refuse_foreign_files(request, measured);
  set_up_drawing();
  for (const auto& file : measured) {
    const auto comparison = process::compare_with_measured(file, request.sources.front().result);
    std::printf("%s", render::report::measured_text(comparison).c_str());
    write_output([&] {
      for (const auto& name : results::write_measured_comparison(request.out, comparison))
        std::printf("%s\n", (request.out / name).string().c_str());
      for (const auto& picture : render::report::measured_pictures(comparison)) {
        const auto png = request.out / ("measured_" + comparison.name + picture.suffix + ".png");
        results::write_text_atomically(png, picture.figure.png.toStdString());
        std::printf("%s\n", png.string().c_str());
      }
    });
  }
  return kDone;
}

}  // namespace diefill::app
