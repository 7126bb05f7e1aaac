// The page live.html of a run in progress: rewritten every few seconds from data that the run has anyway.
#pragma once

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

#include "process/run/fill_run.h"
#include "render/report/live_page.h"

namespace diefill::app {

inline constexpr const char* kLivePage = "live.html";

/// Keeps DIR/live.html. A page is written at most every few seconds, its picture so seldom that drawing takes
/// a hundredth of the time. Where the page cannot be written the run continues without it.
class LiveRun {
 public:
  /// `pictures`: whether to draw. Both references must outlive this object.
  LiveRun(const process::Scene& scene, const process::Tooling& tooling, std::filesystem::path directory,
          bool pictures);

  /// Call this often (RunOptions::watch).
  void update(const process::FillRun& run);
  /// Writes the last page; `how` says how the run ended.
  void end(const process::FillRun& run, const std::string& how, bool done);

 private:
  using Clock = std::chrono::steady_clock;
  void take(const process::FillRun& run);
  void draw(const process::FillRun& run);
  void thin_out();
  void write(bool over, const std::string& state);
  std::string time_left() const;

  const process::Scene& scene_;
  const process::Tooling& tooling_;
  std::filesystem::path directory_;
  bool pictures_, given_up_ = false;
  Clock::time_point start_ = Clock::now(), written_ = start_, next_picture_ = start_;
  double first_share_ = -1;
  render::report::LivePage page_;
};

}  // namespace diefill::app
