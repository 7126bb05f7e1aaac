// Which pairs of centres are near enough to touch, many at once.
#pragma once

#include <cstdint>

#include "engine/numerics/transpose.h"

namespace diefill::engine {

/// Squares of four vectors, `of(k, vector)` sets the k-th, with a fourth number that is 0.
template <class VectorOf>
inline void squares_of_four(const VectorOf& of, double* squares) {
  Four vector[4];
  for (int k = 0; k < 4; ++k) {
    of(k, vector[k]);
    vector[k] *= vector[k];
  }
  // x^2 + y^2 and z^2 + 0 of two vectors each.
  const auto add_neighbours = [](const Four& a, const Four& b, Four& sum) {
    sum = __builtin_shufflevector(a, b, 0, 4, 2, 6) + __builtin_shufflevector(a, b, 1, 5, 3, 7);
  };
  Four lower, upper;
  add_neighbours(vector[0], vector[1], lower);
  add_neighbours(vector[2], vector[3], upper);
  store(__builtin_shufflevector(lower, upper, 0, 1, 4, 5) + __builtin_shufflevector(lower, upper, 2, 3, 6, 7),
        squares);
}

/// Eight bits from eight bytes of 0 or 1, the lowest from the first.
inline std::uint64_t bits_from_bytes(const std::uint8_t* bytes) {
  std::uint64_t eight;
  __builtin_memcpy(&eight, bytes, sizeof eight);
  return eight * 0x0102040810204080U >> 56;
}

}  // namespace diefill::engine
