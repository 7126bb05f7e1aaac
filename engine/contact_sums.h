// Sums of contact forces as they are kept from a block's pairs to the end of the step: closely packed, only
// the numbers that count.
#pragma once

#include <algorithm>
#include <type_traits>
#include <vector>

#include "engine/grains.h"
#include "engine/transpose.h"

namespace diefill::engine {

/// Many ContactSums of which only the first so many numbers are kept; the others are 0.
class ContactSums {
 public:
  std::size_t size() const { return size_; }
  /// Makes room for `count` sums of `numbers` each (ContactSum::kForce, kMoment or kRolling).
  void start(std::size_t count, std::size_t numbers) {
    size_ = count;
    numbers_ = numbers;
    const std::size_t room = count * numbers + kSpare;
    if (value_.size() != room) value_ = std::vector<double>(room);
  }
  /// Bytes that the sums take.
  std::size_t bytes() const { return size_ * numbers_ * sizeof(double); }

  /// Keeps the first size() of `sums`, which become 0.
  void keep(std::vector<ContactSum>& sums) {
    with_numbers([&](auto numbers) {
      double* kept = value_.data();
      // Halves are longer by a number than what is kept of them: the next one is written over it.
      for (std::size_t k = 0; k < size_; ++k, kept += numbers) {
        Four half;
        load(half, sums[k].first_half());
        store(half, kept);
        if constexpr (numbers > ContactSum::kForce) {
          load(half, sums[k].second_half());
          store(half, kept + numbers - kMoment);
        }
        sums[k] = {};
      }
    });
  }
  /// Sets `sums` to the first `count` that are kept.
  void copy_to(std::vector<ContactSum>& sums, std::size_t count) const {
    sums.resize(count);
    with_numbers([&](auto numbers) {
      for (std::size_t k = 0; k < count; ++k) bring<numbers>(k, sums[k]);
    });
  }
  /// Asks for sum k, which is going to be read soon.
  void fetch(std::size_t k) const { __builtin_prefetch(&value_[k * numbers_]); }
  ContactSum operator[](std::size_t k) const {
    ContactSum sum;
    with_numbers([&](auto numbers) { bring<numbers>(k, sum); });
    return sum;
  }

 private:
  static constexpr std::size_t kMoment = 3;  ///< numbers of a moment, kept last
  static constexpr std::size_t kSpare = 1;   ///< numbers behind the last sum, so that halves may be longer

  /// Sets `sum` to the k-th.
  template <std::size_t kNumbers>
  void bring(std::size_t k, ContactSum& sum) const {
    const double* kept = value_.data() + k * kNumbers;
    Four half;
    load(half, kept);
    if constexpr (kNumbers < ContactSum::kRolling) drop_last(half);
    store(half, sum.first_half());
    half = Four{};
    if constexpr (kNumbers > ContactSum::kForce) {
      load(half, kept + kNumbers - kMoment);
      drop_last(half);
    }
    store(half, sum.second_half());
  }

  /// Calls use(numbers) with a constant.
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
