#include "process/continuum/diffusion_length.h"

#include <cstdio>
#include <stdexcept>

namespace diefill::process::continuum {

DiffusionLength constant_length(double length) {
  return [length](double) { return length; };
}

double LengthOfFraction::operator()(double fraction) const {
  const double divisor = fraction <= peak ? 1 - fraction / diverging : 1 + (fraction - 2 * peak) / diverging;
  if (!(divisor > 0) || !(fraction >= 0)) {
    char text[120];
    std::snprintf(text, sizeof text, "the diffusion length has no value at a solid fraction of %.4g",
                  fraction);
    throw std::domain_error(text);
  }
  return smallest / divisor;
}

}  // namespace diefill::process::continuum
