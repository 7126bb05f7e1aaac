// Asks for memory that is going to be read soon. Processors look ahead by themselves, but within a page of
// memory only, and a page holds what 170 grains have in one array.
// Functions that do nothing else are always put in place: GCC takes them for functions without any effect,
// and leaves calls of them out.
#pragma once

#include <cstddef>
#include <vector>

namespace diefill::engine {

/// Bytes of an array between what is worked on and what is asked for, where arrays are worked through from
/// one end to the other: most of a page.
inline constexpr std::size_t kLookAhead = 3072;
/// The same in entries of the array.
template <class Value>
inline constexpr std::size_t kEntriesAhead = kLookAhead / sizeof(Value);

/// Asks for the entries [first, first + kCount) of `values`, as far as there are so many.
template <std::size_t kCount, class Value>
[[gnu::always_inline]] inline void look_at(const std::vector<Value>& values, std::size_t first) {
  constexpr std::size_t kCacheLine = 64;  // bytes
  if (first + kCount > values.size()) return;
  const auto* from = reinterpret_cast<const char*>(values.data() + first);
  for (std::size_t at = 0; at < kCount * sizeof(Value); at += kCacheLine) __builtin_prefetch(from + at);
}

/// Where the entries [first, first + kCount) of each of `arrays` are worked on: asks for those kLookAhead
/// behind them.
template <std::size_t kCount, class... Values>
[[gnu::always_inline]] inline void prefetch(std::size_t first, const std::vector<Values>&... arrays) {
  (look_at<kCount>(arrays, first + kEntriesAhead<Values>), ...);
}

}  // namespace diefill::engine
