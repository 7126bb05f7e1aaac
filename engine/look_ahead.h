// Asks for memory that is going to be read soon. Processors look ahead by themselves, but within a page of
// memory only, and a page holds what 170 grains have in one array.
// Functions that do nothing else are always put in place: GCC takes them for functions without any effect,
// and leaves calls of them out.
#pragma once

#include <cstddef>
#include <vector>

namespace diefill::engine {

/// Asks for the entries [first, first + kCount) of `values`, as far as there are so many.
template <std::size_t kCount, class Value>
[[gnu::always_inline]] inline void look_ahead(const std::vector<Value>& values, std::size_t first) {
  constexpr std::size_t kCacheLine = 64;  // bytes
  if (first + kCount > values.size()) return;
  const auto* from = reinterpret_cast<const char*>(values.data() + first);
  for (std::size_t at = 0; at < kCount * sizeof(Value); at += kCacheLine) __builtin_prefetch(from + at);
}

}  // namespace diefill::engine
