#include "tests/app/shared_report.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <fstream>

#include "engine/numerics/fnv1a.h"
#include "project_paths.h"

namespace diefill::app {

namespace {

namespace fs = std::filesystem;

std::string in_hex(std::uint64_t hash) {
  char text[17];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash));
  return text;
}

/// Where reports of the present program are kept; those of earlier ones are removed.
fs::path folder_of_program() {
  const fs::path program = DIEFILL_PROGRAM, all = program.parent_path() / "fillings_of_tests";
  engine::Fnv1a stamp;
  const auto size = fs::file_size(program);
  const auto written = fs::last_write_time(program).time_since_epoch().count();
  stamp.add_number(size);
  stamp.add_number(written);
  const fs::path own = all / in_hex(stamp.value());
  if (fs::exists(own)) return own;
  fs::remove_all(all);
  fs::create_directories(own);
  return own;
}

}  // namespace

nlohmann::json shared_report(const SmallDie& die) {
  engine::Fnv1a key;
  for (const auto& name : SmallDie::files_in(die.folder())) {
    key.add(name);
    key.add(contents(die.folder() / name));
  }
  const fs::path kept = folder_of_program() / (in_hex(key.value()) + ".json");
  if (fs::exists(kept)) return nlohmann::json::parse(contents(kept));
  const Outcome outcome = die.run();
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  if (outcome.exit_code != 0) return {};
  const fs::path written = kept.string() + "." + std::to_string(getpid());
  std::ofstream(written) << die.report();
  fs::rename(written, kept);
  return die.report();
}

}  // namespace diefill::app
