#include "process/input/numbers_apart.h"

#include <array>
#include <cstdio>

namespace diefill::process {
namespace {

std::string with_digits(double value, int digits) {
  std::array<char, 40> buffer{};
  const int length = std::snprintf(buffer.data(), buffer.size(), "%.*g", digits, value);
  return {buffer.data(), static_cast<std::size_t>(length)};
}

}  // namespace

std::pair<std::string, std::string> numbers_apart(double one, double other) {
  constexpr int kUsual = 6, kExact = 17;
  for (int digits = kUsual; digits < kExact && one != other; ++digits) {
    auto words = std::pair(with_digits(one, digits), with_digits(other, digits));
    if (words.first != words.second) return words;
  }
  const int digits = one == other ? kUsual : kExact;
  return {with_digits(one, digits), with_digits(other, digits)};
}

}  // namespace diefill::process
