// Predicts the cost of a step on more threads than this machine has, from a measurement on a few.
#pragma once

#include <algorithm>
#include <cmath>

namespace diefill::app {

/// Of a step on `threads` threads.
struct StepCounts {
  int threads = 1;
  double seconds = 0;        ///< s, wall-clock time
  double serial_share = 0;   ///< of `seconds`, outside shared loops
  double waiting_share = 0;  ///< of `seconds` times threads, in loops without work
  double blocks = 1;         ///< pieces that the longest loops are divided into
  double bytes = 0;          ///< that move through memory
};

struct Prediction {
  double speedup = 1;           ///< over one thread, where memory does not limit
  double bytes_per_second = 0;  ///< that memory then has to give
};

/// Amdahl's law with the unevenness of whole blocks: the serial part stays, the work of loops is divided
/// among threads, of which the busiest has ceil(blocks / threads) of the blocks. It leaves out memory that
/// threads share and the start of loops, so it is an upper bound.
inline Prediction predict(const StepCounts& counts, int threads) {
  const double serial = counts.serial_share * counts.seconds;
  const double work = counts.threads * (counts.seconds - serial - counts.waiting_share * counts.seconds);
  const double busiest = std::ceil(counts.blocks / threads) / std::max(1.0, counts.blocks);
  const double seconds = serial + work * busiest;
  return {(serial + work) / seconds, counts.bytes / seconds};
}

}  // namespace diefill::app
