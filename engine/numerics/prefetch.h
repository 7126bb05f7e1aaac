// Requests memory before it is read. Processors prefetch by themselves, but only within a page of memory, and
// a page holds what 170 grains have in one array.
// Functions that only prefetch are always inlined: GCC takes them for functions without effect and removes
// calls of them.
#pragma once

#include <cstddef>
#include <vector>

namespace diefill::engine {

/// Bytes of an array between what is processed and what is requested, for arrays processed from one end to
/// the other: most of a page.
inline constexpr std::size_t kPrefetchDistance = 3072;
/// The same in entries of the array.
template <class Value>
inline constexpr std::size_t kEntriesAhead = kPrefetchDistance / sizeof(Value);

/// Requests the entries [first, first + kCount) of `values`, as far as they exist.
template <std::size_t kCount, class Value>
[[gnu::always_inline]] inline void prefetch_entries(const std::vector<Value>& values, std::size_t first) {
  constexpr std::size_t kCacheLine = 64;  // bytes
  if (first + kCount > values.size()) return;
  const auto* from = reinterpret_cast<const char*>(values.data() + first);
  for (std::size_t at = 0; at < kCount * sizeof(Value); at += kCacheLine) __builtin_prefetch(from + at);
}

/// While the entries [first, first + kCount) of each of `arrays` are processed: requests those
/// kPrefetchDistance behind them.
template <std::size_t kCount, class... Values>
[[gnu::always_inline]] inline void prefetch(std::size_t first, const std::vector<Values>&... arrays) {
  (prefetch_entries<kCount>(arrays, first + kEntriesAhead<Values>), ...);
}

}  // namespace diefill::engine
