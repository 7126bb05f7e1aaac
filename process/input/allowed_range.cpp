#include "process/input/allowed_range.h"

#include <cmath>

namespace diefill::process {

std::string allowed_range(std::string_view least, bool above, std::string_view most) {
  std::string words;
  if (!least.empty()) words = (above ? "more than " : "at least ") + std::string(least);
  if (!most.empty()) words += (words.empty() ? "at most " : " and at most ") + std::string(most);
  return "allowed: " + words;
}

bool within(double value, double least, bool above, double most) {
  constexpr double kRounding = 1e-12;
  return (above ? value > least : value >= least - kRounding * std::abs(least)) &&
         value <= most + kRounding * std::abs(most);
}

}  // namespace diefill::process
