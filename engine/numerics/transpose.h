// Four records of four numbers each into four lanes of each number, and back. Memory is read and written in
// records; vector instructions compute with lanes.
#pragma once

#include <cstddef>

namespace diefill::engine {

/// Numbers of one contact or grain, as wide as a cache line: two halves of four.
struct alignas(64) Record {
  static constexpr std::size_t kHalf = 4;
  double value[2 * kHalf];
};

/// GCC's and Clang's vector type: plain instructions where the processor has nothing wider.
using Four = double __attribute__((vector_size(32)));

/// The same in memory, at any alignment of a number. A memcpy would do, but compilers split it for the oldest
/// processors before they know the instruction set; and what was written in pieces must reach the cache
/// before it can be read as a whole.
using FourInMemory = double __attribute__((vector_size(32), aligned(8), may_alias));
/// Half of it.
using Two = double __attribute__((vector_size(16)));
using TwoInMemory = double __attribute__((vector_size(16), aligned(8), may_alias));

/// numbers = from[0], ..., from[3].
inline void load(Four& numbers, const double* from) {
  numbers = *reinterpret_cast<const FourInMemory*>(from);
}
/// numbers = from[0], from[1], from[2], 0, where the number after them must not be read. In two loads: as
/// fast as one, which three are not.
inline void load_three(Four& numbers, const double* from) {
  const Two first = *reinterpret_cast<const TwoInMemory*>(from);
  numbers = __builtin_shufflevector(first, Two{from[2], 0}, 0, 1, 2, 3);
}
/// Writes the numbers back.
inline void store(const Four& numbers, double* to) {
  *reinterpret_cast<FourInMemory*>(to) = numbers;
}

/// Makes the last number 0.
inline void drop_last(Four& numbers) {
  numbers = __builtin_shufflevector(numbers, Four{}, 0, 1, 2, 7);
}
/// to[k] += numbers[k].
inline void add_to(double* to, const Four& numbers) {
  Four sum;
  load(sum, to);
  store(sum + numbers, to);
}

/// Four records, one pair or grain each, in registers.
struct Records {
  static constexpr std::size_t kCount = 4;
  Four row[kCount];

  /// Number k of all records goes to row k, and back.
  void transpose() {
    const Four even = __builtin_shufflevector(row[0], row[1], 0, 4, 2, 6),
               odd = __builtin_shufflevector(row[0], row[1], 1, 5, 3, 7),
               next_even = __builtin_shufflevector(row[2], row[3], 0, 4, 2, 6),
               next_odd = __builtin_shufflevector(row[2], row[3], 1, 5, 3, 7);
    row[0] = __builtin_shufflevector(even, next_even, 0, 1, 4, 5);
    row[1] = __builtin_shufflevector(odd, next_odd, 0, 1, 4, 5);
    row[2] = __builtin_shufflevector(even, next_even, 2, 3, 6, 7);
    row[3] = __builtin_shufflevector(odd, next_odd, 2, 3, 6, 7);
  }
  /// Row k, transposed, to four lanes and from them.
  void to_lanes(std::size_t k, double* lanes) const { store(row[k], lanes); }
  void from_lanes(std::size_t k, const double* lanes) { load(row[k], lanes); }
};

}  // namespace diefill::engine
