#include "geometry/mesh/equal_vertices.h"

#include <algorithm>
#include <array>
#include <bit>
#include <utility>

namespace diefill::geometry {

namespace {

constexpr std::uint32_t kEmpty = 0xffffffffU;
constexpr std::size_t kFirstSize = 1024;

using Bits = std::array<std::uint64_t, 3>;

/// The same for equal points, as adding +0.0 makes both zeros one. NaNs are equal if their bits are: a
/// damaged file may hold millions of them.
Bits bits_of(const Eigen::Vector3d& place) {
  Bits bits;
  for (std::size_t k = 0; k < 3; ++k)
    bits[k] = std::bit_cast<std::uint64_t>(place[static_cast<Eigen::Index>(k)] + 0.0);
  return bits;
}

std::size_t hash_of(const Eigen::Vector3d& place) {
  std::uint64_t hash = 0;
  for (const std::uint64_t bits : bits_of(place)) {
    hash ^= bits;
    hash *= 0x9e3779b97f4a7c15U;
    hash ^= hash >> 32;
  }
  return static_cast<std::size_t>(hash);
}

}  // namespace

std::uint32_t EqualVertices::add(const Eigen::Vector3d& place) {
  if (2 * places_.size() >= table_.size()) resize(table_.empty() ? kFirstSize : 2 * table_.size());
  std::size_t at = hash_of(place) & (table_.size() - 1);
  while (table_[at] != kEmpty && bits_of(places_[table_[at]]) != bits_of(place))
    at = (at + 1) & (table_.size() - 1);
  if (table_[at] == kEmpty) {
    table_[at] = static_cast<std::uint32_t>(places_.size());
    places_.push_back(place);
  }
  return table_[at];
}

void EqualVertices::reserve(std::size_t count) {
  places_.reserve(count);
  if (2 * count > table_.size()) resize(std::max(kFirstSize, std::bit_ceil(2 * count)));
}

void EqualVertices::prefetch(const Eigen::Vector3d& place) const {
  if (!table_.empty()) __builtin_prefetch(&table_[hash_of(place) & (table_.size() - 1)]);
}

std::vector<Eigen::Vector3d> EqualVertices::take_places() {
  table_.clear();
  return std::exchange(places_, {});
}

void EqualVertices::resize(std::size_t size) {
  table_.assign(size, kEmpty);
  for (std::uint32_t i = 0; i < places_.size(); ++i) {
    std::size_t at = hash_of(places_[i]) & (table_.size() - 1);
    while (table_[at] != kEmpty) at = (at + 1) & (table_.size() - 1);
    table_[at] = i;
  }
}

}  // namespace diefill::geometry
