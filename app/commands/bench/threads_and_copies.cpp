#include "app/commands/bench/threads_and_copies.h"

#include <sched.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <thread>

#include "app/commands/bench/more_threads.h"
#include "app/exit_code.h"
#include "app/tables/json_text.h"
#include "process/compare/child_process.h"
#include "process/input/scene_error.h"
#include "process/results/storage/file_contents.h"
#include "process/results/studies/median.h"

namespace diefill::app {

namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

/// Processors that this program may use.
std::vector<int> own_processors() {
  cpu_set_t allowed;
  CPU_ZERO(&allowed);
  if (sched_getaffinity(0, sizeof allowed, &allowed) != 0) return {};
  std::vector<int> processors;
  for (int k = 0; k < CPU_SETSIZE; ++k)
    if (CPU_ISSET(k, &allowed)) processors.push_back(k);
  return processors;
}

/// Of a benchmark, removed at its end.
class Folder {
 public:
  Folder() : path_(fs::temp_directory_path() / ("diefill-bench-" + std::to_string(getpid()))) {
    fs::create_directories(path_);
  }
  ~Folder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  fs::path log(std::size_t k) const { return path_ / std::to_string(k); }

 private:
  fs::path path_;
};

/// Keeps what is started from now on to `processors`.
void pin(const std::vector<int>& processors) {
  cpu_set_t wanted;
  CPU_ZERO(&wanted);
  for (const int processor : processors) CPU_SET(processor, &wanted);
  sched_setaffinity(0, sizeof wanted, &wanted);
}

/// One measurement to be run on some processors.
struct Measurement {
  std::vector<int> processors;
  int threads = 1;
};

std::vector<std::string> arguments_of(const CopiesBenchmark& benchmark, int threads) {
  std::vector<std::string> words = {fs::read_symlink("/proc/self/exe").string()};
  words.insert(words.end(), benchmark.words.begin(), benchmark.words.end());
  words.insert(words.end(), {"--threads", std::to_string(threads), "--json"});
  return words;
}

/// What all of them print, run at the same time.
std::vector<ordered_json> measured(const CopiesBenchmark& benchmark,
                                   const std::vector<Measurement>& measurements) {
  const Folder folder;
  const std::vector<int> own = own_processors();
  std::vector<std::unique_ptr<process::ChildProcess>> running;
  for (const Measurement& one : measurements) {
    pin(one.processors);
    running.push_back(std::make_unique<process::ChildProcess>(arguments_of(benchmark, one.threads),
                                                              folder.log(running.size())));
  }
  pin(own);
  std::vector<ordered_json> figures;
  for (std::size_t k = 0; k < running.size(); ++k) {
    while (!running[k]->ended()) std::this_thread::sleep_for(std::chrono::milliseconds(20));
    const std::string text = results::contents_or_nothing(folder.log(k)).value_or("");
    if (*running[k]->ended() != 0) throw std::runtime_error("bench: a measurement failed: " + text);
    figures.push_back(ordered_json::parse(text));
  }
  return figures;
}

double rate(const ordered_json& figures) {
  return figures.at("sphere_steps_per_second").get<double>();
}

double median_of(const ordered_json& repeats, const char* name) {
  std::vector<double> values;
  for (const auto& repeat : repeats) values.push_back(repeat.at(name).get<double>());
  return results::median(values);
}

/// One measurement: the threads, then the copies.
ordered_json threads_and_copies(const CopiesBenchmark& benchmark, const std::vector<int>& processors) {
  const ordered_json threads = measured(benchmark, {{processors, benchmark.threads}}).front();
  std::vector<Measurement> copies;
  for (const int processor : processors) copies.push_back({{processor}, 1});
  double together = 0;
  for (const ordered_json& copy : measured(benchmark, copies)) together += rate(copy);
  ordered_json repeat;
  repeat["threads"] = rate(threads);
  repeat["copies"] = together;
  repeat["ratio"] = rate(threads) / together;
  for (const char* name : {"serial_share", "waiting_share", "blocks", "bytes_per_step", "seconds_per_step"})
    repeat[name] = threads.at(name);
  return repeat;
}

void print(const ordered_json& outcome, int threads) {
  for (const auto& repeat : outcome.at("repeats"))
    std::printf("%d threads %.2f, copies %.2f million sphere-steps/s, ratio %.3f\n", threads,
                1e-6 * repeat.at("threads").get<double>(), 1e-6 * repeat.at("copies").get<double>(),
                repeat.at("ratio").get<double>());
  std::printf("median ratio: %.3f\n", outcome.at("ratio").get<double>());
  std::printf("serial: %.1f %% of the step; waiting in loops: %.1f %% of the time of all threads\n",
              100 * outcome.at("serial_share").get<double>(),
              100 * outcome.at("waiting_share").get<double>());
  for (const auto& more : outcome.at("predicted"))
    std::printf("%d threads, predicted from these counts: speed-up at most %.1f, if memory gives %.0f GB/s\n",
                more.at("threads").get<int>(), more.at("speedup").get<double>(),
                1e-9 * more.at("bytes_per_second").get<double>());
}

}  // namespace

int compare_with_copies(const CopiesBenchmark& benchmark) {
  std::vector<int> processors = own_processors();
  if (static_cast<int>(processors.size()) < benchmark.threads)
    throw process::SceneError("bench: --against-copies with --threads " + std::to_string(benchmark.threads) +
                              " needs as many processors, found: " + std::to_string(processors.size()) +
                              "; use fewer threads");
  processors.resize(static_cast<std::size_t>(benchmark.threads));
  ordered_json outcome;
  for (int k = 0; k < benchmark.repeats; ++k)
    outcome["repeats"].push_back(threads_and_copies(benchmark, processors));
  for (const char* name : {"ratio", "serial_share", "waiting_share"})
    outcome[name] = median_of(outcome["repeats"], name);
  const StepCounts counts = {benchmark.threads,
                             median_of(outcome["repeats"], "seconds_per_step"),
                             outcome["serial_share"].get<double>(),
                             outcome["waiting_share"].get<double>(),
                             outcome["repeats"][0]["blocks"].get<double>(),
                             outcome["repeats"][0]["bytes_per_step"].get<double>()};
  for (const int more : {16, 64}) {
    const Prediction predicted = predict(counts, more);
    outcome["predicted"].push_back({{"threads", more},
                                    {"speedup", predicted.speedup},
                                    {"bytes_per_second", predicted.bytes_per_second}});
  }
  if (benchmark.json)
    std::printf("%s\n", json_text(outcome).c_str());
  else
    print(outcome, benchmark.threads);
  return kDone;
}

}  // namespace diefill::app
