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

/// sum + way * given, number by number.
inline void add_times(double* sum, const Record& given, const Eight& way) {
  Eight total, added;
  __builtin_memcpy(&total, sum, sizeof total);
  __builtin_memcpy(&added, given.value, sizeof added);
  total += way * added;
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

/// Number k of eight records goes to `lanes[k][0..7]`, for k below `kCount`.
template <std::size_t kCount>
inline void records_to_lanes(const Record* records, double* const (&lanes)[kCount]) {
  Eight row[8];
  for (std::size_t k = 0; k < 8; ++k) __builtin_memcpy(&row[k], records[k].value, sizeof row[k]);
  transposition::transpose(row);
  for (std::size_t k = 0; k < kCount; ++k) __builtin_memcpy(lanes[k], &row[k], sizeof row[k]);
}

/// The way back; numbers from `kCount` on are 0.
template <std::size_t kCount>
inline void lanes_to_records(const double* const (&lanes)[kCount], Record* records) {
  Eight row[8] = {};
  for (std::size_t k = 0; k < kCount; ++k) __builtin_memcpy(&row[k], lanes[k], sizeof row[k]);
  transposition::transpose(row);
  for (std::size_t k = 0; k < 8; ++k) __builtin_memcpy(records[k].value, &row[k], sizeof row[k]);
}

}  // namespace diefill::engine
