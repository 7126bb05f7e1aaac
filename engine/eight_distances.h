// Whether eight pairs of centres are near enough to touch, at once.
#pragma once

#include <cstdint>

#include "engine/transpose.h"

namespace diefill::engine {

/// Squares of eight vectors, `of(k)` the k-th, with a fourth number that is 0.
template <class VectorOf>
inline void squares_of_eight(const VectorOf& of, Eight& squares) {
  Eight two[4];
  for (int k = 0; k < 4; ++k) {
    Four first, second;
    of(2 * k, first);
    of(2 * k + 1, second);
    two[k] = __builtin_shufflevector(first, second, 0, 1, 2, 3, 4, 5, 6, 7);
    two[k] *= two[k];
  }
  // x^2 + y^2 and z^2 + 0 of four vectors each, in the order 0 2 1 3.
  const auto add_neighbours = [](const Eight& a, const Eight& b, Eight& sum) {
    sum = __builtin_shufflevector(a, b, 0, 8, 2, 10, 4, 12, 6, 14) +
          __builtin_shufflevector(a, b, 1, 9, 3, 11, 5, 13, 7, 15);
  };
  Eight lower, upper;
  add_neighbours(two[0], two[1], lower);
  add_neighbours(two[2], two[3], upper);
  squares = __builtin_shufflevector(lower, upper, 0, 4, 1, 5, 8, 12, 9, 13) +
            __builtin_shufflevector(lower, upper, 2, 6, 3, 7, 10, 14, 11, 15);
}

/// Eight bytes, the first in the lowest bits: 1 where a < b, 0 elsewhere.
inline std::uint64_t bytes_where_less(const Eight& a, const Eight& b) {
  using Bytes = std::int8_t __attribute__((vector_size(8)));
  const Bytes less = __builtin_convertvector(a < b, Bytes);  // -1 where true
  std::uint64_t bytes;
  __builtin_memcpy(&bytes, &less, sizeof bytes);
  return bytes & 0x0101010101010101U;
}

/// Eight bits from eight bytes of 0 or 1, the lowest from the first.
inline std::uint64_t bits_from_bytes(std::uint64_t bytes) {
  return bytes * 0x0102040810204080U >> 56;
}

}  // namespace diefill::engine
