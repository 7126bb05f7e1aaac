// Damping ratios that give a stated coefficient of restitution.
#pragma once

#include <cmath>
#include <numbers>

namespace diefill::engine::laws {

/// -beta = -ln e / sqrt(ln^2 e + pi^2), from 0 (e = 1, undamped) to 1 (e = 0) (Hu 2024, Eq. 2.27). The same
/// ratio serves the linear spring: gamma = -2 beta sqrt(M k) is Kottlan 2018, Eq. 7.
inline double restitution_damping_ratio(double restitution) {
  if (restitution <= 0) return 1;
  if (restitution >= 1) return 0;
  const double logarithm = std::log(restitution);
  return -logarithm / std::sqrt(logarithm * logarithm + std::numbers::pi * std::numbers::pi);
}

}  // namespace diefill::engine::laws
