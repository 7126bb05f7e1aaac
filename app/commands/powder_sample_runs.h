// `diefill run --powder-samples K`: a scene with powders drawn from a calibration's region.
#pragma once

#include <filesystem>
#include <string>

#include "process/scene/scene.h"

namespace diefill::app {

struct PowderSampleArguments {
  int powders = 0;  ///< 0: no such runs
  int seeds = 4;    ///< runs of the best powder
  int jobs = 1;
  int threads = 0;  ///< of each run; 0: the cores shared evenly
  bool quiet = false;
};

/// Runs them in `directory`, resumes runs that are there, and writes the report. Returns the exit code.
int run_powder_samples(const process::Scene& scene, const std::filesystem::path& directory,
                       const PowderSampleArguments& arguments);

}  // namespace diefill::app
