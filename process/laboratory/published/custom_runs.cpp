#include "process/laboratory/published/custom_runs.h"

#include <chrono>
#include <ctime>
#include <fstream>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>

#include "engine/numerics/out_of_range.h"
#include "engine/numerics/seconds_since.h"
#include "engine/numerics/thread_pool.h"
#include "process/results/storage/atomic_file.h"
#include "process/results/storage/hashed_file.h"
#include "process/results/studies/job_list.h"
#include "process/run/fill_run.h"
#include "process/run/restart/byte_stream.h"
#include "process/tooling/progress.h"

namespace diefill::process::laboratory {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr const char *kResult = "result.json", *kCheckpoint = "checkpoint.bin";

fs::path folder_of(const fs::path& directory, const CustomRun& run, std::uint64_t seed) {
  return directory / results::job_folder(run.name, seed);
}

/// s of processor time of this thread.
double thread_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// What a stopped run keeps.
struct RunCheckpoint {
  std::string settings, state;
  std::uint64_t seed = 0;
  double core_seconds = 0, share = 0;
};

template <class Io, class Contents>
void transfer(Io& io, Contents& checkpoint) {
  io(checkpoint.settings);
  io(checkpoint.seed);
  io(checkpoint.core_seconds);
  io(checkpoint.share);
  io(checkpoint.state);
}

void write_checkpoint(const fs::path& file, const RunCheckpoint& checkpoint) {
  ByteWriter writer;
  transfer(writer, checkpoint);
  results::write_text_atomically(file, results::with_hash(writer.bytes()));
}

/// Of this run; an empty one where there is none, or it is damaged or another run's.
RunCheckpoint read_checkpoint(const fs::path& file, const CustomRun& run, std::uint64_t seed) {
  RunCheckpoint found;
  if (!fs::exists(file)) return found;
  try {
    if (const auto bytes = results::read_hashed(file)) {
      ByteReader reader(*bytes);
      transfer(reader, found);
    }
  } catch (const results::ResultError&) {
    return {};
  }
  if (found.settings != run.settings || found.seed != seed) return {};
  return found;
}

void write_kept(const fs::path& folder, const CustomRun& run, std::uint64_t seed,
                const StoredCustomRun& kept) {
  nlohmann::ordered_json json = {
      {"run", run.name}, {"settings", run.settings}, {"seed", seed}, {"core_seconds", kept.core_seconds}};
  if (kept.finished)
    json["result"] = nlohmann::ordered_json::parse(kept.result);
  else
    json["failure"] = kept.failure;
  results::write_text_atomically(
      folder / kResult, json.dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n");
  fs::remove(folder / kCheckpoint);
}

/// Nothing where there is no such file, or it is damaged or another run's.
std::optional<StoredCustomRun> read_kept(const fs::path& path, const CustomRun& run, std::uint64_t seed) {
  std::ifstream file(path);
  const auto json = nlohmann::ordered_json::parse(file, nullptr, false);
  try {
    if (json.at("settings") != run.settings || json.at("seed") != seed) return std::nullopt;
    StoredCustomRun kept;
    kept.core_seconds = json.at("core_seconds");
    kept.finished = json.contains("result");
    if (kept.finished)
      kept.result = json["result"].dump();
    else
      kept.failure = json.at("failure");
    return kept;
  } catch (const nlohmann::json::exception&) {
    return std::nullopt;
  }
}

/// All runs while they are made.
class CustomRunQueue {
 public:
  CustomRunQueue(const std::vector<CustomRun>& runs, const LabJobs& jobs)
      : jobs_(jobs), progress_(jobs.options.show_progress) {
    for (int seed = 1; seed <= jobs.seeds; ++seed)
      for (const CustomRun& run : runs) add(run, static_cast<std::uint64_t>(seed));
  }

  void make() {
    engine::ThreadPool(jobs_.options.at_once).for_each(waiting_.size(), [&](std::size_t k) {
      if (!may_go_on()) return;
      make(waiting_[k]);
    });
    if (stopped_by_user())
      throw Interrupted(
          "stopped; finished runs and the checkpoints of the others are kept: run the same command again "
          "to continue");
  }

 private:
  struct Waiting {
    const CustomRun* run;
    std::uint64_t seed;
    double share = 0, core_seconds = 0;
  };

  /// One of them in progress.
  class Watch final : public CustomRunWatch {
   public:
    Watch(CustomRunQueue& all, Waiting& one)
        : all_(all), one_(one), folder_(folder_of(all.jobs_.directory, *one.run, one.seed)) {
      RunCheckpoint kept = read_checkpoint(folder_ / kCheckpoint, *one.run, one.seed);
      begun_ = std::move(kept.state);
      before_ = kept.core_seconds;
    }
    const fs::path& folder() const override { return folder_; }
    const std::string& begun() const override { return begun_; }
    double core_seconds() const { return before_ + thread_seconds() - began_; }
    void report(double share, const std::function<std::string()>& state) override {
      all_.report(one_, share, core_seconds());
      const bool goes_on = all_.may_go_on();
      if (goes_on && engine::seconds_since(kept_) < kCustomRunCheckpoint) return;
      kept_ = Clock::now();
      write_checkpoint(folder_ / kCheckpoint,
                       {one_.run->settings, state(), one_.seed, core_seconds(), share});
      if (!goes_on) throw CustomRunStopped(one_.run->name);
    }

   private:
    CustomRunQueue& all_;
    Waiting& one_;
    fs::path folder_;
    std::string begun_;
    double before_ = 0, began_ = thread_seconds();
    Clock::time_point kept_ = Clock::now();
  };

  void add(const CustomRun& run, std::uint64_t seed) {
    all_work_ += run.work;
    const StoredCustomRun kept = stored_custom_run(jobs_.directory, run, seed);
    spent_ += kept.core_seconds;
    double share = 1;
    if (!kept.finished && kept.failure.empty()) {
      share = read_checkpoint(folder_of(jobs_.directory, run, seed) / kCheckpoint, run, seed).share;
      waiting_.push_back({&run, seed, share, kept.core_seconds});
    }
    done_work_ += share * run.work;
  }

  void make(Waiting& one) {
    fs::create_directories(folder_of(jobs_.directory, *one.run, one.seed));
    Watch watch(*this, one);
    StoredCustomRun kept;
    try {
      kept.result = one.run->make(one.seed, watch);
      kept.finished = true;
    } catch (const CustomRunStopped&) {
      return;
    } catch (const engine::OutOfRange& error) {
      kept.failure = error.what();
    }
    kept.core_seconds = watch.core_seconds();
    write_kept(watch.folder(), *one.run, one.seed, kept);
    report(one, 1, kept.core_seconds);
  }

  bool stopped_by_user() const { return jobs_.options.stop != nullptr && *jobs_.options.stop; }
  bool may_go_on() {
    const std::lock_guard lock(mutex_);
    return !stopped_by_user() && spent_ < jobs_.options.cpu_seconds;
  }

  void report(Waiting& one, double share, double core_seconds) {
    const std::lock_guard lock(mutex_);
    done_work_ += (share - one.share) * one.run->work;
    made_work_ += (share - one.share) * one.run->work;
    spent_ += core_seconds - one.core_seconds;
    made_seconds_ += core_seconds - one.core_seconds;
    one.share = share, one.core_seconds = core_seconds;
    char rate[60];
    std::snprintf(rate, sizeof rate, "%.2f million particle steps a core second",
                  1e-6 * made_work_ / std::max(1e-9, made_seconds_));
    progress_.show(done_work_ / std::max(1.0, all_work_), one.run->name, rate);
  }

  const LabJobs& jobs_;
  Progress progress_;
  std::mutex mutex_;
  std::vector<Waiting> waiting_;
  double all_work_ = 0, done_work_ = 0, made_work_ = 0;  ///< particle steps; of this call
  double spent_ = 0, made_seconds_ = 0;                  ///< s of processor time; of this call
};

}  // namespace

void make_custom_runs(const std::vector<CustomRun>& runs, const LabJobs& jobs) {
  CustomRunQueue(runs, jobs).make();
}

StoredCustomRun stored_custom_run(const fs::path& directory, const CustomRun& run, std::uint64_t seed) {
  const fs::path folder = folder_of(directory, run, seed);
  if (const auto kept = read_kept(folder / kResult, run, seed)) return *kept;
  StoredCustomRun unfinished;
  unfinished.core_seconds = read_checkpoint(folder / kCheckpoint, run, seed).core_seconds;
  return unfinished;
}

}  // namespace diefill::process::laboratory
