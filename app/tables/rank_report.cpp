#include "app/tables/rank_report.h"

#include <cstdio>

#include "process/cluster/rank_forecast.h"
#include "process/tooling/progress.h"

namespace diefill::app {

using process::cluster::RankStep;

void print_rank_forecast(const process::plan::Plan& plan, int threads, int ranks) {
  const auto& forecast = plan.choices.front().forecast;
  if (!forecast.wall_seconds || forecast.grains == 0) {
    std::printf("on %d ranks: unknown without the pilot run\n", ranks);
    return;
  }
  const auto grains = static_cast<double>(forecast.grains);
  const std::size_t spheres = forecast.spheres / forecast.grains;
  process::cluster::RankCosts costs;
  costs.built_in_step = threads * *forecast.wall_seconds / forecast.sphere_steps();
  const RankStep step = process::cluster::rank_step(grains, spheres, ranks, costs);
  std::printf("on %d ranks: %s, on %d threads of one machine %s\n", ranks,
              process::duration_text(step.seconds * forecast.steps()).c_str(), threads,
              process::duration_text(*forecast.wall_seconds).c_str());
  std::printf(
      "  a rank has %.0f grains and copies of %.0f others; in a step it sends and receives %.0f messages, "
      "%.3g kB\n",
      step.own, step.ghosts, step.messages, 1e-3 * step.bytes);
  const double pay = process::cluster::break_even_grains(spheres, ranks, threads, costs);
  if (pay > 0)
    std::printf("  %d ranks are quicker than %d threads from about %.2g grains on", ranks, threads, pay);
  else
    std::printf("  %d ranks are never quicker than %d threads", ranks, threads);
  std::printf(
      " (a rank steps %.1f times slower than a thread, measured; network of %.0f us and %.0f GB/s, "
      "assumed)\n",
      costs.slower, 1e6 * costs.latency, 1e-9 * costs.bandwidth);
}

}  // namespace diefill::app
