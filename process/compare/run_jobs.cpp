#include "process/compare/run_jobs.h"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <regex>

#include "engine/numerics/seconds_since.h"
#include "process/compare/child_process.h"
#include "process/compare/job_folder.h"
#include "process/results/storage/atomic_file.h"
#include "process/results/storage/directory_lock.h"
#include "process/results/studies/job_cost.h"
#include "process/run/fill_run.h"
#include "process/tooling/progress.h"

namespace diefill::process {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr useconds_t kPause = 20000;                 // microseconds between looks at the jobs
constexpr const char* kSharedStarts = "beginnings";  // folder, while jobs are under way
constexpr std::chrono::seconds kReportInterval(5);
constexpr int kBadSignal = 128;  // exit codes from here on: ended by a signal, or stopped and resumable

/// Share of the work that a job's log last reported, 0 to 1.
double share_in(const fs::path& log) {
  constexpr std::streamoff kTail = 2000;
  std::ifstream file(log, std::ios::ate);
  if (!file) return 0;
  file.seekg(std::max<std::streamoff>(0, static_cast<std::streamoff>(file.tellg()) - kTail));
  double share = 0;
  for (std::string line; std::getline(file, line);)
    if (line.find(" %  t = ") != std::string::npos) share = std::atof(line.c_str()) / 100;
  return share;
}

/// Removes the checkpoints that runs share (run/restart/shared_start.h), and their folder if that leaves it
/// empty. Other files there stay.
void remove_shared_starts(const fs::path& folder) {
  static const std::regex ours(R"([0-9a-f]{16}\.bin(\..*\.tmp)?)");
  std::error_code error;
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder, error))
    if (std::regex_match(entry.path().filename().string(), ours)) files.push_back(entry.path());
  for (const fs::path& file : files) fs::remove(file, error);
  fs::remove(folder, error);
}

struct RunningJob {
  const results::Job* job = nullptr;
  std::unique_ptr<ChildProcess> process;
  Clock::time_point started = Clock::now();
};

/// The jobs of a list while they run.
class JobPool {
 public:
  JobPool(const fs::path& directory, const results::JobList& list, const JobOptions& options)
      : directory_(directory),
        list_(list),
        options_(options),
        progress_(options.show_progress),
        all_(list.jobs.size()) {
    for (const auto& job : list.jobs) {
      const JobState state = state_of(directory, job);
      const bool over = state.stage == JobState::Stage::finished || state.out_of_range();
      if (!over) waiting_.push_back(&job);
      spent_ += results::read_job_cost(directory / job.folder).cpu_seconds;
    }
    done_ = done_before_ = all_ - waiting_.size();
    if (done_ > 0)
      progress_.note(std::to_string(done_) + " of " + std::to_string(all_) + " runs are already done");
  }

  void run() {
    while (!waiting_.empty() || !running_.empty()) {
      if (options_.stop != nullptr && options_.stop->load()) stop();
      while (!waiting_.empty() && running_.size() < static_cast<std::size_t>(options_.at_once)) start_next();
      ::usleep(kPause);
      take_ended();
      if (left() <= 0) end_early();
      show();
      if (Clock::now() - reported_ > kReportInterval) report();
    }
    report();
    remove_shared_starts(directory_ / kSharedStarts);
  }

 private:
  static std::string description(const results::Job& job) {
    return '"' + job.variant + "\", seed " + std::to_string(job.seed);
  }

  /// s of processor time that the jobs may still take.
  double left() const {
    double running = 0;
    for (const RunningJob& job : running_) running += job.process->cost().cpu_seconds;
    return options_.cpu_seconds - spent_ - running;
  }

  /// The run of a comparison that was killed may still be writing its checkpoint.
  void wait_for_earlier_run(const fs::path& folder) const {
    constexpr auto kLongestWait = std::chrono::seconds(60);
    const auto start = Clock::now();
    const auto stop_requested = [this] { return options_.stop != nullptr && options_.stop->load(); };
    while (results::lock_holder(folder) && !stop_requested() && Clock::now() - start < kLongestWait)
      ::usleep(kPause);
  }

  void start_next() {
    const results::Job& job = *waiting_.front();
    waiting_.erase(waiting_.begin());
    if (options_.starts && !options_.starts(job, left())) {
      --all_;
      return;
    }
    const fs::path folder = directory_ / job.folder;
    wait_for_earlier_run(folder);
    fs::remove(folder / kJobExitCode);
    const int threads =
        options_.threads > 0 ? options_.threads : std::max(1, options_.cores / options_.at_once);
    RunningJob running;
    running.job = &job;
    std::vector<std::string> words = {options_.program.string(),
                                      "run",
                                      (folder / kJobScene).string(),
                                      "--out",
                                      folder.string(),
                                      "--resume",
                                      "--threads",
                                      std::to_string(threads)};
    if (!options_.pictures) words.push_back("--no-pictures");
    if (options_.share_starts)
      words.insert(words.end(), {"--beginnings", (directory_ / kSharedStarts).string()});
    running.process = std::make_unique<ChildProcess>(words, folder / kJobLog);
    progress_.note("started " + description(job));
    running_.push_back(std::move(running));
  }

  void take_ended() {
    for (RunningJob& running : running_)
      if (const auto code = running.process->ended()) record_finished(running, *code);
    std::erase_if(running_, [](const RunningJob& running) { return running.job == nullptr; });
  }

  void record_finished(RunningJob& running, int code) {
    const results::Job& job = *running.job;
    const double seconds = engine::seconds_since(running.started);
    const ProcessCost cost = running.process->cost();
    results::add_job_cost(directory_ / job.folder, {cost.cpu_seconds, seconds, cost.peak_memory_bytes});
    spent_ += cost.cpu_seconds;
    running.job = nullptr;
    ++done_;
    const bool asked = ending_early_ || (options_.stop != nullptr && options_.stop->load());
    const bool stopped = asked && code >= kBadSignal;
    if (!stopped)
      results::write_text_atomically(directory_ / job.folder / kJobExitCode, std::to_string(code) + "\n");
    const JobState state = state_of(directory_, job);
    const std::string end = state.stage == JobState::Stage::failed ? "failed: " + state.reason : "finished";
    if (!stopped) progress_.note(description(job) + ' ' + end + " (" + duration_text(seconds) + ')');
  }

  void show() {
    if (Clock::now() - looked_ > std::chrono::seconds(1)) {
      looked_ = Clock::now();
      share_of_running_ = 0;
      for (const RunningJob& running : running_)
        share_of_running_ += share_in(directory_ / running.job->folder / kJobLog);
    }
    progress_.show(share_done(), std::to_string(done_) + " of " + std::to_string(all_) + " runs done",
                   std::to_string(running_.size()) + " running");
  }

  double share_done() const {
    return (static_cast<double>(done_) + share_of_running_) /
           static_cast<double>(std::max<std::size_t>(all_, 1));
  }

  JobProgress state_now(const results::Job& job) const {
    for (const RunningJob& running : running_)
      if (running.job == &job)
        return {&job, "running", share_in(directory_ / job.folder / kJobLog),
                engine::seconds_since(running.started)};
    if (std::find(waiting_.begin(), waiting_.end(), &job) != waiting_.end()) return {&job, "waiting", 0, 0};
    const JobState state = state_of(directory_, job);
    if (state.stage == JobState::Stage::finished) return {&job, "finished", 1, 0};
    return {&job, state.stage == JobState::Stage::failed ? state.reason : "not finished", 0, 0};
  }

  /// Calls JobOptions::watch.
  void report() {
    reported_ = Clock::now();
    if (!options_.watch) return;
    JobListProgress all;
    for (const auto& job : list_.jobs) all.jobs.push_back(state_now(job));
    all.share = share_done();
    all.seconds = engine::seconds_since(began_);
    all.first_share = static_cast<double>(done_before_) / static_cast<double>(std::max<std::size_t>(all_, 1));
    options_.watch(all);
  }

  void stop_running() {
    for (RunningJob& running : running_) running.process->interrupt();
    while (!running_.empty()) {
      ::usleep(kPause);
      take_ended();
    }
  }

  void end_early() {
    ending_early_ = true;
    stop_running();
    waiting_.clear();
  }

  [[noreturn]] void stop() {
    stop_running();
    throw Interrupted("stopped: " + std::to_string(waiting_.size()) +
                      " runs were not started, the active ones stopped at a checkpoint; " +
                      options_.to_continue);
  }

  const fs::path& directory_;
  const results::JobList& list_;
  const JobOptions& options_;
  Progress progress_;
  std::vector<const results::Job*> waiting_;
  std::vector<RunningJob> running_;
  std::size_t all_, done_ = 0, done_before_ = 0;
  double share_of_running_ = 0;
  double spent_ = 0;  ///< s of processor time of all jobs that are not running
  bool ending_early_ = false;
  Clock::time_point looked_ = Clock::now(), began_ = looked_, reported_ = looked_;
};

}  // namespace

void run_jobs(const fs::path& directory, const results::JobList& list, const JobOptions& options) {
  JobPool(directory, list, options).run();
}

}  // namespace diefill::process
