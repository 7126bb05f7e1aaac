// Sums of contact forces from a block's pairs to the end of the step: closely packed, only the numbers that
// count, forces separate from moments, so that the integrator can use them directly.
#pragma once

#include <algorithm>
#include <type_traits>
#include <vector>

#include "engine/numerics/prefetch.h"
#include "engine/numerics/transpose.h"
#include "engine/powder/grains.h"

namespace diefill::engine {

/// Many ContactSums of which only the first so many numbers are kept; the others are 0.
class ContactSums {
 public:
  std::size_t size() const { return size_; }
  /// Makes room for `count` sums of `numbers` each (ContactSum::kForce, kMoment or kRolling).
  void start(std::size_t count, std::size_t numbers) {
    size_ = count;
    numbers_ = numbers;
    if (value_.size() != room()) value_ = std::vector<double>(room());
  }
  /// Bytes that the sums take.
  std::size_t bytes() const { return size_ * numbers_ * sizeof(double); }

  /// Keeps the first size() of `sums`, which become 0.
  void keep(std::vector<ContactSum>& sums) {
    with_numbers([&](auto numbers) {
      for (std::size_t k = 0; k < size_; ++k) {
        if (k + kAhead < size_) fetch(k + kAhead);
        put(sums[k].first_half(), forces() + kVector * k);
        if constexpr (numbers > ContactSum::kForce) put(sums[k].second_half(), moments() + kVector * k);
        if constexpr (numbers > ContactSum::kMoment) loads()[k] = sums[k].rolling_load();
        sums[k] = {};
      }
    });
  }
  /// Becomes the first `count` sums of `other`.
  void copy_first(const ContactSums& other, std::size_t count) {
    size_ = count;
    numbers_ = other.numbers_;
    if (value_.size() < room()) value_.resize(room());
    std::copy_n(other.forces(), kVector * count, forces());
    if (numbers_ > ContactSum::kForce) std::copy_n(other.moments(), kVector * count, moments());
    if (numbers_ > ContactSum::kMoment) std::copy_n(other.loads(), count, loads());
  }

  /// N, three numbers per sum, and N m, as in ContactSum: of all sums one after the other. There must be
  /// such.
  const double* forces() const { return value_.data(); }
  const double* moments() const { return value_.data() + moments_begin(); }
  /// N m, rolling loads.
  const double* loads() const { return value_.data() + loads_begin(); }

  Vector3 force(std::size_t k) const { return vector_at(forces() + kVector * k); }
  Vector3 moment(std::size_t k) const {
    return numbers_ > ContactSum::kForce ? vector_at(moments() + kVector * k) : Vector3{};
  }
  double rolling_load(std::size_t k) const { return numbers_ > ContactSum::kMoment ? loads()[k] : 0; }

  void add_force(std::size_t k, Vector3 force) { add_to_vector(forces() + kVector * k, force); }
  /// Does nothing where moments do not count.
  void add_moment(std::size_t k, Vector3 moment) {
    if (numbers_ > ContactSum::kForce) add_to_vector(moments() + kVector * k, moment);
  }
  /// Does nothing where loads do not count.
  void add_rolling_load(std::size_t k, double load) {
    if (numbers_ > ContactSum::kMoment) loads()[k] += load;
  }
  /// Requests sum k before it is read.
  /// Always inlined: prefetch.h gives the reason.
  [[gnu::always_inline]] void fetch(std::size_t k) const {
    __builtin_prefetch(forces() + kVector * k);
    if (numbers_ > ContactSum::kForce) __builtin_prefetch(moments() + kVector * k);
  }

 private:
  static constexpr std::size_t kVector = 3;  ///< numbers of a force or moment
  static constexpr std::size_t kAhead = kEntriesAhead<double> / kVector;
  static constexpr std::size_t kSpare = 1;  ///< after each array, so that vectors are written four at a time

  std::size_t moments_begin() const { return kVector * size_ + kSpare; }
  std::size_t loads_begin() const { return 2 * moments_begin(); }
  std::size_t room() const { return size_ * numbers_ + 2 * kSpare; }
  double* forces() { return value_.data(); }
  double* moments() { return value_.data() + moments_begin(); }
  double* loads() { return value_.data() + loads_begin(); }

  static Vector3 vector_at(const double* from) { return {from[0], from[1], from[2]}; }
  static void add_to_vector(double* to, Vector3 added) {
    to[0] += added.x;
    to[1] += added.y;
    to[2] += added.z;
  }

  /// Vectors are longer by a number than what is kept of them: the next one is written over it.
  static void put(const double* half, double* kept) {
    Four numbers;
    load(numbers, half);
    store(numbers, kept);
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
