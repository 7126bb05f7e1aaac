#include "app/commands/live_jobs.h"

#include <algorithm>
#include <cstdio>

#include "app/commands/live_run.h"
#include "process/results/storage/atomic_file.h"
#include "process/results/storage/result_file.h"
#include "process/tooling/progress.h"
#include "render/report/live_page.h"

namespace diefill::app {
namespace {

namespace fs = std::filesystem;

/// Rounded down, so that 100 % stands for all.
std::string percent_rounded_down(double share) {
  return std::to_string(static_cast<int>(100 * share)) + " %";
}

/// "12 min left"; empty where that is not known.
std::string time_left(const process::JobListProgress& all) {
  const double done = all.share - all.first_share;
  return done > 0 ? ", " + process::duration_text(all.seconds * (1 - all.share) / done) + " left" : "";
}

render::report::LivePage page_of(const process::JobListProgress& all, const std::string& title,
                                 const fs::path& directory) {
  render::report::LivePage page;
  page.title = title;
  page.share = all.share;
  page.over = std::none_of(all.jobs.begin(), all.jobs.end(),
                           [](const auto& job) { return job.state == "waiting" || job.state == "running"; });
  const auto finished = std::count_if(all.jobs.begin(), all.jobs.end(),
                                      [](const auto& job) { return job.state == "finished"; });
  page.state = std::to_string(finished) + " of " + std::to_string(all.jobs.size()) + " runs finished" +
               (page.over ? "" : time_left(all));
  page.header = {"Run", "Seed", "State", "Done", "Time"};
  for (const auto& job : all.jobs) {
    page.rows.push_back({job.job->variant, std::to_string(job.job->seed), job.state,
                         percent_rounded_down(job.share),
                         job.seconds > 0 ? process::duration_text(job.seconds) : "–"});
    const fs::path own = fs::path(job.job->folder) / kLivePage;
    page.links.push_back(fs::exists(directory / own) ? own.generic_string() : "");
  }
  return page;
}

}  // namespace

std::function<void(const process::JobListProgress&)> live_jobs(const fs::path& directory,
                                                               const std::string& title) {
  return [directory, title, given_up = false](const process::JobListProgress& all) mutable {
    if (given_up) return;
    try {
      results::write_text_atomically(directory / kLivePage,
                                     render::report::live_html(page_of(all, title, directory)));
    } catch (const results::ResultError& error) {
      given_up = true;
      std::fprintf(stderr, "note: %s; the runs go on without it\n", error.what());
    }
  };
}

}  // namespace diefill::app
