// Standard normal numbers that are the same on every machine, for tests.
#pragma once

#include <cmath>
#include <numbers>
#include <random>

namespace diefill::process::calibration {

/// By Box and Muller.
class Normal {
 public:
  explicit Normal(unsigned seed) : generator_(seed) {}
  double operator()() {
    const double a = uniform(), b = uniform();
    return std::sqrt(-2 * std::log(a)) * std::cos(2 * std::numbers::pi * b);
  }
  /// In (0, 1).
  double uniform() { return (static_cast<double>(generator_()) + 0.5) / 4294967296.0; }

 private:
  std::mt19937 generator_;
};

}  // namespace diefill::process::calibration
