// Feeds damaged CAD files to the importers as the program runs them, in child processes, and to the check and
// the repair, and reports what happened (README.md): anything but a mesh or one MeshError is a failure.
//   bin/import_fuzz SECONDS [SEED]      damaged files of every kind
//   bin/import_fuzz --replay FILES...   inputs that the guided fuzzer kept
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <random>

#include "tests/fuzz/fuzz_input.h"
#include "tests/support/temporary_folder.h"

namespace diefill::geometry::fuzz {
namespace {

/// Damages files as transport, editors and attackers do.
class Damage {
 public:
  explicit Damage(std::uint64_t seed) : random_(seed) {}

  std::string of(std::string bytes) {
    const int blows = 1 + pick(6);
    for (int blow = 0; blow < blows && !bytes.empty(); ++blow) strike(bytes);
    return bytes;
  }
  std::size_t pick(std::size_t count) {
    return std::uniform_int_distribution<std::size_t>(0, count - 1)(random_);
  }

 private:
  void strike(std::string& bytes) {
    const std::size_t at = pick(bytes.size());
    const std::size_t length = std::min(bytes.size() - at, 1 + pick(64));
    static const char* const kWords[] = {"nan", "1e308", "-1", "4294967295", "0", "2147483648",
                                         "inf", "\n",    " ",  "<",          "#"};
    switch (pick(8)) {
      case 0:
        bytes[at] = static_cast<char>(bytes[at] ^ (1 << pick(8)));
        break;
      case 1:
        bytes[at] = static_cast<char>(pick(256));
        break;
      case 2:
        bytes.erase(at, length);
        break;
      case 3:
        bytes.insert(pick(bytes.size()), bytes.substr(at, length));
        break;
      case 4:
        bytes.resize(at);
        break;
      case 5:
        bytes.replace(at, std::min<std::size_t>(length, 1 + pick(10)), kWords[pick(std::size(kWords))]);
        break;
      case 6:
        for (std::size_t k = 0; k < std::min<std::size_t>(4, bytes.size() - at); ++k) bytes[at + k] = '\xff';
        break;
      default:
        replace_number(bytes, at);
    }
  }

  /// The number at or after a place becomes another one.
  void replace_number(std::string& bytes, std::size_t at) {
    const std::size_t begin = bytes.find_first_of("0123456789", at);
    if (begin == std::string::npos) return;
    const std::size_t end = bytes.find_first_not_of("0123456789", begin);
    bytes.replace(begin, (end == std::string::npos ? bytes.size() : end) - begin,
                  std::to_string(pick(100000)));
  }

  std::mt19937_64 random_;
};

/// Counts how inputs ended, and what they took.
class Outcomes {
 public:
  void take(const FuzzInput& input) {
    const auto file = folder_.write("input." + input.ending, input.bytes);
    const auto begun = Clock::now();
    ++times_[input.ending + ": " + outcome_of(file)];
    longest_ = std::max(longest_, seconds_since(begun));
    ++inputs_;
  }
  double seconds() const { return seconds_since(start_); }
  void print() const {
    for (const auto& [outcome, times] : times_) std::printf("%8zu  %s\n", times, outcome.c_str());
    rusage self{}, children{};
    getrusage(RUSAGE_SELF, &self);
    getrusage(RUSAGE_CHILDREN, &children);
    std::printf("%zu inputs in %.0f s; longest %.2f s; largest memory %.0f MB here, %.0f MB in a child\n",
                inputs_, seconds(), longest_, 1e-3 * static_cast<double>(self.ru_maxrss),
                1e-3 * static_cast<double>(children.ru_maxrss));
  }

 private:
  using Clock = std::chrono::steady_clock;
  static double seconds_since(Clock::time_point then) {
    return std::chrono::duration<double>(Clock::now() - then).count();
  }

  support::TemporaryFolder folder_;
  Clock::time_point start_ = Clock::now();
  std::map<std::string, std::size_t> times_;
  std::size_t inputs_ = 0;
  double longest_ = 0;
};

void damage_for(double seconds, std::uint64_t seed, Outcomes& outcomes) {
  const auto all = seeds();
  Damage damage(seed);
  while (outcomes.seconds() < seconds) {
    const FuzzInput& input = all[damage.pick(all.size())];
    outcomes.take({input.ending, damage.of(input.bytes)});
  }
}

}  // namespace
}  // namespace diefill::geometry::fuzz

int main(int count, char** arguments) {
  using namespace diefill::geometry::fuzz;
  Outcomes outcomes;
  if (count > 2 && std::string(arguments[1]) == "--replay") {
    for (int k = 2; k < count; ++k) {
      const std::string bytes = diefill::support::contents(arguments[k]);
      if (!bytes.empty()) outcomes.take(unpacked(bytes));
    }
  } else {
    damage_for(count > 1 ? std::atof(arguments[1]) : 60,
               count > 2 ? std::strtoull(arguments[2], nullptr, 10) : 1, outcomes);
  }
  outcomes.print();
  return 0;
}
