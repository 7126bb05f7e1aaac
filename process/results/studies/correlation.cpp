#include "process/results/studies/correlation.h"

#include <cmath>
#include <limits>
#include <numeric>

namespace diefill::results {

double pearson_correlation(const std::vector<double>& a, const std::vector<double>& b) {
  constexpr std::size_t kFewest = 3;
  constexpr double kRounding = 1e-12, kUndetermined = std::numeric_limits<double>::quiet_NaN();
  if (a.size() < kFewest) return kUndetermined;
  const auto count = static_cast<double>(a.size());
  const double mean_a = std::accumulate(a.begin(), a.end(), 0.0) / count,
               mean_b = std::accumulate(b.begin(), b.end(), 0.0) / count;
  double ab = 0, aa = 0, bb = 0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    ab += (a[k] - mean_a) * (b[k] - mean_b);
    aa += (a[k] - mean_a) * (a[k] - mean_a);
    bb += (b[k] - mean_b) * (b[k] - mean_b);
  }
  const auto varies = [&](double squares, double mean) {
    return squares > std::pow(kRounding * mean, 2) * count;
  };
  return varies(aa, mean_a) && varies(bb, mean_b) ? ab / std::sqrt(aa * bb) : kUndetermined;
}

}  // namespace diefill::results
