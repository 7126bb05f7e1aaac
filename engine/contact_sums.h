// Sums of contact forces as they are kept from a block's pairs to the end of the step: closely packed, only
// the numbers that count.
#pragma once

#include <algorithm>
#include <type_traits>
#include <vector>

#include "engine/grains.h"

namespace diefill::engine {

/// Many ContactSums of which only the first so many numbers are kept; the others are 0.
class ContactSums {
 public:
  std::size_t size() const { return size_; }
  /// Makes room for `count` sums of `numbers` each (ContactSum::kForce, kMoment or kRolling).
  void start(std::size_t count, std::size_t numbers) {
    size_ = count;
    numbers_ = numbers;
    if (value_.size() != count * numbers) value_ = std::vector<double>(count * numbers);
  }
  /// Bytes that the sums take.
  std::size_t bytes() const { return value_.size() * sizeof(double); }

  /// Keeps the first size() of `sums`, which become 0.
  void keep(std::vector<ContactSum>& sums) {
    with_numbers([&]<std::size_t kNumbers>(std::integral_constant<std::size_t, kNumbers>) {
      double* kept = value_.data();
      for (std::size_t k = 0; k < size_; ++k) {
        __builtin_memcpy(kept + k * kNumbers, sums[k].data(), kNumbers * sizeof(double));
        sums[k] = {};
      }
    });
  }
  /// Sets `sums` to the first `count` that are kept.
  void copy_to(std::vector<ContactSum>& sums, std::size_t count) const {
    sums.resize(count);
    with_numbers([&]<std::size_t kNumbers>(std::integral_constant<std::size_t, kNumbers>) {
      const double* kept = value_.data();
      for (std::size_t k = 0; k < count; ++k) {
        double* sum = sums[k].data();
        __builtin_memcpy(sum, kept + k * kNumbers, kNumbers * sizeof(double));
        for (std::size_t n = kNumbers; n < 8; ++n) sum[n] = 0;
      }
    });
  }
  /// Asks for sum k, which is going to be read soon.
  void fetch(std::size_t k) const { __builtin_prefetch(&value_[k * numbers_]); }
  ContactSum operator[](std::size_t k) const {
    ContactSum sum;
    with_numbers([&]<std::size_t kNumbers>(std::integral_constant<std::size_t, kNumbers>) {
      __builtin_memcpy(sum.data(), &value_[k * kNumbers], kNumbers * sizeof(double));
    });
    return sum;
  }

 private:
  template <class Use>
  void with_numbers(const Use& use) const {
    if (numbers_ == ContactSum::kForce)
      use(std::integral_constant<std::size_t, ContactSum::kForce>{});
    else if (numbers_ == ContactSum::kMoment)
      use(std::integral_constant<std::size_t, ContactSum::kMoment>{});
    else
      use(std::integral_constant<std::size_t, ContactSum::kRolling>{});
  }

  std::size_t size_ = 0, numbers_ = ContactSum::kRolling;
  std::vector<double> value_;
};

}  // namespace diefill::engine
