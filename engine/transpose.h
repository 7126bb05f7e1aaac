// Between records and lanes: eight records of eight numbers each turn into eight lanes of each number.
// Records are what memory is read and written in, lanes are what vector instructions compute with.
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>

namespace diefill::engine {

/// Numbers of one contact or grain, as wide as a cache line.
struct alignas(64) Record {
  double value[8];
};

/// GCC's and Clang's vector type: plain instructions where the processor has nothing better.
using Eight = double __attribute__((vector_size(64)));

using Four = double __attribute__((vector_size(32)));

/// The record's numbers.
inline void take(Eight& numbers, const Record& record) {
  __builtin_memcpy(&numbers, record.value, sizeof numbers);
}
/// sum + way * given, number by number.
inline void add_times(double* sum, const Eight& given, const Eight& way) {
  Eight total;
  __builtin_memcpy(&total, sum, sizeof total);
  total += way * given;
  __builtin_memcpy(sum, &total, sizeof total);
}

namespace transposition {

using Places = std::int64_t __attribute__((vector_size(64)));

/// Exchanges blocks of `kSize` numbers between `upper` and `lower`: one of three rounds.
template <std::int64_t kSize>
inline void exchange(Eight& upper, Eight& lower) {
  Places first{}, second{};
  for (std::int64_t k = 0; k < 8; ++k) {
    const bool swapped = (k / kSize) % 2 == 1;
    first[k] = swapped ? 8 + k - kSize : k;
    second[k] = swapped ? 8 + k : k + kSize;
  }
  const Eight kept = upper;
  upper = __builtin_shuffle(kept, lower, first);
  lower = __builtin_shuffle(kept, lower, second);
}

inline void transpose(Eight (&row)[8]) {
  for (const int k : {0, 2, 4, 6}) exchange<1>(row[k], row[k + 1]);
  for (const int k : {0, 1, 4, 5}) exchange<2>(row[k], row[k + 2]);
  for (const int k : {0, 1, 2, 3}) exchange<4>(row[k], row[k + 4]);
}

}  // namespace transposition

/// Eight records, one pair or grain each, in registers.
struct Records {
  Eight row[8];

  /// Number k of all records goes to row k, and back.
  void transpose() { transposition::transpose(row); }
  /// Row k, transposed, to eight lanes and from them.
  void store(std::size_t k, double* lanes) const { __builtin_memcpy(lanes, &row[k], sizeof row[k]); }
  void load(std::size_t k, const double* lanes) { __builtin_memcpy(&row[k], lanes, sizeof row[k]); }
};

}  // namespace diefill::engine
