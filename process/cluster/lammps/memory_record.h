// Contact history of a touching pair, stored with a grain while the grain may move to another rank.
#pragma once

#include <cstdint>
#include <vector>

namespace diefill::process::cluster {

/// A record is a row of numbers: how many follow the head, partner, own sphere, other sphere, then the
/// history of the pair as seen from the grain that stores it. The partner is a grain's tag, or at walls the
/// body counted from -1 down; the other sphere is then the wall sphere's number in the simulation.
struct MemoryRecord {
  static constexpr std::size_t kHead = 4;

  static constexpr double body_key(std::size_t body) { return -1.0 - static_cast<double>(body); }

  static void append(std::vector<double>& memory, double partner, double own, double other,
                     const double* history, std::size_t width, const double* sign = nullptr) {
    memory.insert(memory.end(), {static_cast<double>(width), partner, own, other});
    for (std::size_t k = 0; k < width; ++k) memory.push_back(sign ? sign[k] * history[k] : history[k]);
  }

  /// The history of the pair, or nullptr where it did not touch.
  static const double* find(const std::vector<double>& memory, double partner, double own, double other) {
    for (std::size_t at = 0; at < memory.size(); at += kHead + static_cast<std::size_t>(memory[at]))
      if (memory[at + 1] == partner && memory[at + 2] == own && memory[at + 3] == other)
        return memory.data() + at + kHead;
    return nullptr;
  }
};

}  // namespace diefill::process::cluster
