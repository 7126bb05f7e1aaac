// Means over seeds and the significance of their difference.
#pragma once

#include <cstddef>
#include <vector>

namespace diefill::process {

/// A measure over seeds.
struct Sample {
  double mean = 0;        ///< NaN for no values
  double scatter = 0;     ///< standard deviation of a sample (n - 1); NaN for fewer than two values
  std::size_t count = 0;  ///< finite values
};

/// Values that are not finite do not count. With a `period` (as 360 for azimuths in degrees) the mean is the
/// direction of the sum of unit vectors, in 0 to `period`, and the scatter that of the shorter ways to it.
Sample sample_of(const std::vector<double>& values, double period = 0);

/// b - a; with a period the shorter way round, within half a period.
double difference(double a, double b, double period = 0);

/// Half width of the 95 % interval of the difference of two means by Welch's t: t_{0.975, nu} times
/// sqrt(s_a^2 / n_a + s_b^2 / n_b), nu after Welch and Satterthwaite (B. L. Welch, Biometrika 34, 1947).
/// NaN where one of them has fewer than two values; zero where neither scatters.
double welch_half_width(const Sample& a, const Sample& b);

}  // namespace diefill::process
