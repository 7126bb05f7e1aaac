#include "app/commands/powder_sample_runs.h"

#include <algorithm>
#include <cstdio>
#include <thread>

#include "app/backup_notes.h"
#include "app/exit_code.h"
#include "app/output.h"
#include "app/pictures/drawing.h"
#include "app/stop_signals.h"
#include "process/calibration/powder_samples.h"
#include "process/compare/job_folder.h"
#include "process/compare/run_jobs.h"
#include "process/results/storage/atomic_file.h"
#include "process/run/assemble.h"
#include "render/report/html.h"
#include "render/report/powder_spread_report.h"

namespace diefill::app {
namespace {

namespace calibration = process::calibration;

void write_report(const std::filesystem::path& directory, const results::PowderSpread& spread) {
  write_output([&] {
    results::write_powder_spread(directory, spread);
    set_up_drawing();
    results::write_text_atomically(directory / "powder_samples.html",
                                   render::report::html_page(render::report::powder_spread_document(spread)));
  });
}

void print(const std::filesystem::path& directory, const results::PowderSpread& spread) {
  for (const auto& figure : spread.figures) std::printf("%s\n", results::spread_text(figure).c_str());
  for (const auto& failed : spread.failed) std::printf("note: %s\n", failed.c_str());
  std::printf("in %s: powder_samples.html, powder_samples.json, powder_samples.csv\n",
              directory.string().c_str());
}

}  // namespace

int run_powder_samples(const process::Scene& scene, const std::filesystem::path& directory,
                       const PowderSampleArguments& arguments) {
  const auto region = calibration::powder_region_of(scene.file);
  calibration::refuse_own_values(scene, region);
  const auto powders = calibration::drawn_samples(region, arguments.powders, scene.seed);
  const auto variants = calibration::powder_variants(scene, region, powders, arguments.seeds);
  const OutputDirectory output(directory, {"tools"});
  make_output_directory(directory);
  results::JobList list;
  write_output([&] { list = process::write_jobs(directory, {scene.title, variants, 1, {}}, print_note); });
  process::JobOptions options;
  options.program = std::filesystem::read_symlink("/proc/self/exe");
  options.at_once = arguments.jobs;
  options.cores = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  options.threads = arguments.threads;
  options.pictures = false;
  options.show_progress = !arguments.quiet;
  options.stop = &install_stop_handlers();
  process::run_jobs(directory, list, options);
  auto spread = calibration::powder_spread(directory, region, powders, arguments.seeds);
  spread.program_version = process::program_version();
  spread.command = "diefill run " + scene.file.string() + " --powder-samples " +
                   std::to_string(arguments.powders) + " --seeds " + std::to_string(arguments.seeds);
  write_report(directory, spread);
  print(directory, spread);
  return spread.failed.empty() ? kDone : kFailed;
}

}  // namespace diefill::app
