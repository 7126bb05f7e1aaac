#include "process/tooling/progress.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>

namespace diefill::process {

namespace {

constexpr double kQuietStart = 2, kOnTerminal = 0.1, kElsewhere = 10;  // s
constexpr int kBarWidth = 24;

/// s between lines where standard error is no terminal; the environment states it for programs that show
/// progress themselves.
double seconds_between_lines() {
  const char* text = std::getenv("DIEFILL_PROGRESS_SECONDS");
  const double seconds = text == nullptr ? 0 : std::strtod(text, nullptr);
  return seconds > 0 ? seconds : kElsewhere;
}

double seconds_between(std::chrono::steady_clock::time_point a, std::chrono::steady_clock::time_point b) {
  return std::chrono::duration<double>(b - a).count();
}

}  // namespace

Progress::Progress(bool wanted) : wanted_(wanted), terminal_(isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
  clear_bar();
}

void Progress::show(double share, const std::string& doing, const std::string& rate) {
  if (!wanted_) return;
  const auto now = Clock::now();
  if (first_share_ < 0) first_share_ = share;
  const double elapsed = seconds_between(start_, now);
  const double interval = terminal_ ? kOnTerminal : seconds_between_lines();
  const double quiet_start = terminal_ ? kQuietStart : std::min(kQuietStart, interval);
  if (elapsed < quiet_start || seconds_between(last_, now) < interval) return;
  last_ = now;
  share = std::clamp(share, 0.0, 1.0);
  const double done = share - first_share_;
  std::string words = doing;
  if (!rate.empty()) words += "  " + rate;
  if (done > 0) words += "  " + duration_text(elapsed * (1 - share) / done) + " left";
  if (!terminal_) {
    std::fprintf(stderr, "%3.0f %%  %s\n", 100 * share, words.c_str());
    return;
  }
  const int full = static_cast<int>(share * kBarWidth);
  std::fprintf(
      stderr, "\r\033[K[%s%s] %3.0f %%  %s", std::string(static_cast<std::size_t>(full), '#').c_str(),
      std::string(static_cast<std::size_t>(kBarWidth - full), '.').c_str(), 100 * share, words.c_str());
  std::fflush(stderr);
  bar_ = true;
}

ProgressCallback Progress::callback() {
  return [this](double share, const std::string& doing) { show(share, doing, ""); };
}

void Progress::note(const std::string& line) {
  if (wanted_) warn(line);
}

void Progress::warn(const std::string& line) {
  clear_bar();
  std::fprintf(stderr, "%s\n", line.c_str());
}

void Progress::clear_bar() {
  if (bar_) std::fprintf(stderr, "\r\033[K");
  bar_ = false;
}

std::string duration_text(double seconds) {
  constexpr double kYears = 1000 * 365.25 * 86400;
  if (!(seconds < kYears)) return "more than 1000 years";
  char text[64];
  const auto whole = static_cast<long>(seconds + 0.5);
  if (whole >= 3600)
    std::snprintf(text, sizeof text, "%ld h %02ld min", whole / 3600, whole % 3600 / 60);
  else if (whole >= 60)
    std::snprintf(text, sizeof text, "%ld min %02ld s", whole / 60, whole % 60);
  else
    std::snprintf(text, sizeof text, "%ld s", whole);
  return text;
}

}  // namespace diefill::process
