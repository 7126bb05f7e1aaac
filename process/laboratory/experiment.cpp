#include "process/laboratory/experiment.h"

#include <ctime>

namespace diefill::process::laboratory {

results::ExperimentResult perform(const Experiment& experiment, const ExperimentOptions& options) {
  results::ExperimentResult result;
  result.name = experiment.name;
  result.question = experiment.question;
  result.quick = options.quick;
  const std::clock_t begin = std::clock();
  experiment.perform(options, result);
  result.cpu_seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  return result;
}

}  // namespace diefill::process::laboratory
