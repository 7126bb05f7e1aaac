// How often a plan opens the CAD files: as often as one reading of the tools does.
#include <gtest/gtest.h>
#include <sys/inotify.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "process/plan/plan.h"
#include "process/scene/scene_text.h"
#include "process/setup/read_tooling.h"
#include "project_paths.h"
#include "tests/support/temporary_folder.h"

namespace diefill::process::plan {
namespace {

namespace fs = std::filesystem;

/// Counts how often a file is opened while it lives. Reads and closings are watched as well: equal events in
/// a row would become one.
class Opened {
 public:
  explicit Opened(const fs::path& file) : events_(inotify_init1(IN_NONBLOCK)) {
    inotify_add_watch(events_, file.c_str(), IN_OPEN | IN_ACCESS | IN_CLOSE_NOWRITE);
  }
  ~Opened() { close(events_); }
  Opened(const Opened&) = delete;
  Opened& operator=(const Opened&) = delete;

  int count() {
    alignas(inotify_event) char buffer[4096];
    for (ssize_t length; (length = read(events_, buffer, sizeof buffer)) > 0;)
      for (char* event = buffer; event < buffer + length;) {
        const auto* one = reinterpret_cast<const inotify_event*>(event);
        count_ += (one->mask & IN_OPEN) != 0;
        event += sizeof(inotify_event) + one->len;
      }
    return count_;
  }

 private:
  int events_, count_ = 0;
};

/// The square die as it is shipped, with a setting of the planner's in place of its own numbers.
fs::path scene_with_setting(const support::TemporaryFolder& folder) {
  const fs::path shipped = fs::path(DIEFILL_SOURCE_DIR) / "sample_tools/small_dies";
  for (const char* name : {"square_die.stl", "square_punch.stl", "square_shoe.stl"})
    fs::copy_file(shipped / name, folder.path() / name);
  std::ifstream file(shipped / "square.toml");
  std::string text = "setting = \"quick\"\n";
  for (std::string line; std::getline(file, line);) {
    const bool chosen = line.rfind("grain_diameter", 0) == 0 || line.rfind("spacing", 0) == 0 ||
                        line.rfind("fill_height", 0) == 0;
    text += chosen ? "" : line + "\n";
  }
  return folder.write("scene.toml", text);
}

TEST(Plan, ReadsEachToolOnce) {
  const support::TemporaryFolder folder;
  const Scene scene = read_scene(scene_with_setting(folder));
  const fs::path die = folder.path() / "square_die.stl";
  const int by_one_reading = [&] {
    Opened opened(die);
    read_tooling(scene);
    return opened.count();
  }();
  ASSERT_GT(by_one_reading, 0);
  Opened by_plan(die);
  PlanOptions options;
  options.pilot = false;
  const Plan plan = make_plan(scene, options);
  EXPECT_EQ(plan.choices.size(), 4U);
  EXPECT_EQ(by_plan.count(), by_one_reading);
}

}  // namespace
}  // namespace diefill::process::plan
