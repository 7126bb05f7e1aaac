// Wall time that has passed.
#pragma once

#include <chrono>

namespace diefill::engine {

/// s
inline double seconds_since(std::chrono::steady_clock::time_point then) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - then).count();
}

}  // namespace diefill::engine
