#include "tests/app/shared_report.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <fstream>
#include <stdexcept>

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

/// Where results of the present program are kept; those of earlier ones are removed.
fs::path folder_of_program() {
  const fs::path program = DIEFILL_PROGRAM, all = program.parent_path() / "fillings_of_tests";
  engine::Fnv1a stamp;
  const auto size = fs::file_size(program);
  const auto written = fs::last_write_time(program).time_since_epoch().count();
  stamp.add_number(size);
  stamp.add_number(written);
  const fs::path own = all / in_hex(stamp.value());
  if (fs::exists(own)) return own;
  fs::create_directories(own);  // first: another test may be about to do the same
  for (const auto& entry : fs::directory_iterator(all))
    if (entry.path() != own) fs::remove_all(entry.path());
  return own;
}

/// The files that lie in the die's folder, by name and content.
engine::Fnv1a files_of(const SmallDie& die) {
  engine::Fnv1a key;
  for (const auto& name : SmallDie::files_in(die.folder())) {
    if (!fs::is_regular_file(die.folder() / name)) continue;
    key.add(name);
    key.add(contents(die.folder() / name));
  }
  return key;
}

}  // namespace

nlohmann::json shared_report(const SmallDie& die) {
  const fs::path kept = folder_of_program() / (in_hex(files_of(die).value()) + ".json");
  if (fs::exists(kept)) return nlohmann::json::parse(contents(kept));
  const Outcome outcome = die.run({"--no-pictures"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  if (outcome.exit_code != 0) return {};
  const fs::path written = kept.string() + "." + std::to_string(getpid());
  std::ofstream(written) << die.report();
  fs::rename(written, kept);
  return die.report();
}

fs::path shared_folder(const SmallDie& die, const std::string& what,
                       const std::function<void(const fs::path& folder)>& fill) {
  engine::Fnv1a key = files_of(die);
  key.add(what);
  const fs::path kept = folder_of_program() / in_hex(key.value());
  if (fs::exists(kept)) return kept;
  const fs::path written = kept.string() + "." + std::to_string(getpid());
  fs::create_directories(written);
  try {
    fill(written);
  } catch (...) {
    fs::remove_all(written);
    throw;
  }
  std::error_code filled_by_another;
  fs::rename(written, kept, filled_by_another);
  if (filled_by_another) fs::remove_all(written);
  return kept;
}

void take_shared_results(const SmallDie& die) {
  const auto kept = shared_folder(die, "results", [&](const fs::path& folder) {
    const Outcome outcome = run_program({"run", die.scene().string(), "--out", folder.string(), "--threads",
                                         "1", "--quiet", "--no-pictures"});
    if (outcome.exit_code != 0) throw std::runtime_error(outcome.err);
  });
  fs::copy(kept, die.out(), fs::copy_options::recursive);
}

}  // namespace diefill::app
