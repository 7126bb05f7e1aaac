#include "engine/grain_pair_table.h"

#include <bit>

namespace diefill::engine {

void GrainPairTable::start(std::size_t count, std::size_t numbers) {
  width_ = numbers;
  make_room(pair, count);
  make_room(is_close_, (count + kWord - 1) / kWord);
  close_.clear();
  touching_.clear();
  memory_.assign(width_, 0.0);
  margin_ = 0;
}

void GrainPairTable::add(const GrainPair& added, const double* remembered, const double* sign) {
  if (pair.size() % kWord == 0) is_close_.push_back(0);
  pair.push_back(added);
  if (!remembered) return;
  add_touching(pair.size() - 1);
  for (std::size_t k = 0; k < width_; ++k) memory_.push_back(sign ? sign[k] * remembered[k] : remembered[k]);
}

void GrainPairTable::finish() {
  memory_.insert(memory_.end(), kSpare, 0.0);
  memory_.shrink_to_fit();
}

void GrainPairTable::recall(std::size_t p, const double* remembered) {
  add_touching(p);
  memory_.insert(memory_.end() - kSpare, remembered, remembered + width_);
}

/// Near pair p becomes the last of the close ones.
void GrainPairTable::add_touching(std::size_t p) {
  is_close_[p / kWord] |= std::uint64_t{1} << p % kWord;
  const std::size_t k = close_.size();
  if (k % kWord == 0) touching_.push_back(0);
  close_.push_back(pair[p]);
  touching_.back() |= std::uint64_t{1} << k % kWord;
}

void GrainPairTable::list_close(const std::vector<std::uint64_t>& near, double margin) {
  thread_local std::vector<GrainPair> close;
  thread_local std::vector<std::uint64_t> touching;
  make_room(close, close_.size() + close_.size() / 8);
  touching.clear();
  std::size_t before = 0;
  for (std::size_t w = 0; w < near.size(); ++w) {
    std::uint64_t touched = 0;  // a bit a near pair
    for (std::uint64_t left = is_close_[w]; left != 0; left &= left - 1, ++before)
      touched |= (left ^ (left & (left - 1))) & (bit(touching_, before) ? ~std::uint64_t{0} : 0);
    is_close_[w] = near[w] | touched;
    for (std::uint64_t left = is_close_[w]; left != 0; left &= left - 1) {
      const auto lowest = static_cast<std::size_t>(std::countr_zero(left));
      const std::size_t k = close.size();
      if (k % kWord == 0) touching.push_back(0);
      close.push_back(pair[w * kWord + lowest]);
      touching.back() |= (touched >> lowest & 1U) << k % kWord;
    }
  }
  close_.swap(close);
  touching_.swap(touching);
  margin_ = margin;
}

void GrainPairTable::make_room_to_remember(std::vector<double>& remembered, std::size_t count) const {
  const std::size_t needed = (count + 1) * width_ + kSpare;
  // Contacts come and go, and rooms go from block to block: fresh memory costs more than some that is idle.
  if (remembered.capacity() < needed || remembered.capacity() > 2 * needed)
    make_room(remembered, needed + needed / 8);
  remembered.resize(needed);
  std::fill_n(remembered.begin(), width_, 0.0);
}

}  // namespace diefill::engine
