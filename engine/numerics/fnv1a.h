// The FNV-1a hash of Fowler, Noll and Vo, 64 bits: a number that shows whether two sequences of bytes are the
// same.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <type_traits>

namespace diefill::engine {

/// Hash of all that has been added, in this order.
class Fnv1a {
 public:
  void add(const void* data, std::size_t bytes) {
    const auto* byte = static_cast<const unsigned char*>(data);
    for (std::size_t k = 0; k < bytes; ++k) value_ = (value_ ^ byte[k]) * 0x100000001b3ULL;
  }
  void add(std::string_view text) { add(text.data(), text.size()); }
  /// The bytes of a number.
  template <class Number>
  void add_number(Number number) {
    static_assert(std::is_arithmetic_v<Number>, "other values may hold padding, whose bytes mean nothing");
    add(&number, sizeof number);
  }
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325ULL;
};

}  // namespace diefill::engine
