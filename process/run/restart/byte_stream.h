// Values as bytes, for files that only this program reads back: checkpoints.
#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <type_traits>
#include <vector>

#include "process/results/storage/result_file.h"

namespace diefill::process {

/// Appends values to a string of bytes. ByteReader takes the same values back in the same order: one function
/// that passes every value to either writes and reads.
class ByteWriter {
 public:
  template <class Value>
  void operator()(const Value& value) {
    static_assert(!std::is_pointer_v<Value>);
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  template <class Value>
  void operator()(const std::vector<Value>& values) {
    (*this)(static_cast<std::uint64_t>(values.size()));
    bytes_.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(Value));
  }
  void operator()(const std::string& text) {
    (*this)(static_cast<std::uint64_t>(text.size()));
    bytes_ += text;
  }
  void operator()(const std::vector<std::string>& texts) {
    (*this)(static_cast<std::uint64_t>(texts.size()));
    for (const std::string& text : texts) (*this)(text);
  }
  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

/// Throws results::ResultError where there are fewer bytes than values.
class ByteReader {
 public:
  explicit ByteReader(std::string bytes) : bytes_(std::move(bytes)) {}
  template <class Value>
  void operator()(Value& value) {
    take(&value, sizeof value);
  }
  template <class Value>
  void operator()(std::vector<Value>& values) {
    values.resize(count_of(sizeof(Value)));
    take(values.data(), values.size() * sizeof(Value));
  }
  void operator()(std::string& text) {
    text.resize(count_of(1));
    take(text.data(), text.size());
  }
  void operator()(std::vector<std::string>& texts) {
    texts.resize(count_of(sizeof(std::uint64_t)));
    for (std::string& text : texts) (*this)(text);
  }

 private:
  std::uint64_t count_of(std::size_t size) {
    std::uint64_t count = 0;
    (*this)(count);
    if (count > (bytes_.size() - at_) / size) throw results::ResultError("it is damaged");
    return count;
  }
  void take(void* target, std::size_t size) {
    if (bytes_.size() - at_ < size) throw results::ResultError("it is truncated");
    if (size > 0) std::memcpy(target, bytes_.data() + at_, size);
    at_ += size;
  }
  std::string bytes_;
  std::size_t at_ = 0;
};

}  // namespace diefill::process
