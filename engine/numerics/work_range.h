// Consecutive items of a loop that a thread has still to do. The thread takes them from the front; others,
// when they have finished their own, from the back.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace diefill::engine {

/// Any number of threads may take items at the same time; each item is taken once.
class WorkRange {
 public:
  /// [begin, end), below 2^32. Not while others take items.
  void set(std::size_t begin, std::size_t end) { range_.store(packed(begin, end)); }
  void clear() { range_.store(0); }

  std::optional<std::size_t> take_first() {
    std::uint64_t range = range_.load();
    while (begin(range) < end(range))
      if (range_.compare_exchange_weak(range, packed(begin(range) + 1, end(range)))) return begin(range);
    return std::nullopt;
  }

  std::optional<std::size_t> take_last() {
    std::uint64_t range = range_.load();
    while (begin(range) < end(range))
      if (range_.compare_exchange_weak(range, packed(begin(range), end(range) - 1))) return end(range) - 1;
    return std::nullopt;
  }

 private:
  static std::uint64_t packed(std::size_t begin, std::size_t end) {
    return static_cast<std::uint64_t>(begin) << 32 | static_cast<std::uint64_t>(end);
  }
  static std::size_t begin(std::uint64_t range) { return range >> 32; }
  static std::size_t end(std::uint64_t range) { return range & 0xFFFFFFFF; }

  std::atomic<std::uint64_t> range_{0};
};

}  // namespace diefill::engine
