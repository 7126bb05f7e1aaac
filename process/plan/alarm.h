// A flag that is set after a given time.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>

namespace diefill::process::plan {

/// Sets `flag` after some time, unless the alarm is destroyed first.
class Alarm {
 public:
  Alarm(double seconds, std::atomic<bool>& flag)
      : deadline_(in(seconds)), thread_([this, &flag] {
          std::unique_lock lock(mutex_);
          while (!gone_ && Clock::now() < deadline_) changed_.wait_until(lock, deadline_);
          if (!gone_) flag.store(true);
        }) {}
  ~Alarm() {
    {
      const std::lock_guard lock(mutex_);
      gone_ = true;
    }
    changed_.notify_all();
    thread_.join();
  }
  /// Sets the alarm to `seconds` (s) from now.
  void postpone(double seconds) {
    const std::lock_guard lock(mutex_);
    deadline_ = in(seconds);
    changed_.notify_all();
  }
  Alarm(const Alarm&) = delete;
  Alarm& operator=(const Alarm&) = delete;

 private:
  using Clock = std::chrono::steady_clock;
  static Clock::time_point in(double seconds) {
    return Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  bool gone_ = false;
  Clock::time_point deadline_;
  std::thread thread_;
};

}  // namespace diefill::process::plan
