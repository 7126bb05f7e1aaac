// Values as bytes, for messages between ranks of one program on machines of one kind.
#pragma once

#include <cstring>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace diefill::process::cluster {

/// Bytes that values are appended to and read from in the same order.
class Packet {
 public:
  Packet() = default;
  explicit Packet(std::vector<char> bytes) : bytes_(std::move(bytes)) {}
  const std::vector<char>& bytes() const { return bytes_; }

  template <class Value>
  void put(const Value& value) {
    static_assert(std::is_trivially_copyable_v<Value>);
    append(&value, sizeof value);
  }
  void put(const std::string& text) { put(std::vector<char>(text.begin(), text.end())); }
  template <class Value>
  void put(const std::vector<Value>& values) {
    put(values.size());
    if constexpr (std::is_trivially_copyable_v<Value>)
      append(values.data(), values.size() * sizeof(Value));
    else
      for (const Value& value : values)
        for (const double number : value) put(number);  // Eigen's vectors
  }

  template <class Value>
  void take(Value& value) {
    static_assert(std::is_trivially_copyable_v<Value>);
    read(&value, sizeof value);
  }
  void take(std::string& text) {
    std::vector<char> letters;
    take(letters);
    text.assign(letters.begin(), letters.end());
  }
  template <class Value>
  void take(std::vector<Value>& values) {
    std::size_t count = 0;
    take(count);
    values.resize(count);
    if constexpr (std::is_trivially_copyable_v<Value>)
      read(values.data(), count * sizeof(Value));
    else
      for (Value& value : values)
        for (double& number : value) take(number);
  }

 private:
  void append(const void* from, std::size_t count) {
    const std::size_t end = bytes_.size();
    bytes_.resize(end + count);
    if (count > 0) std::memcpy(bytes_.data() + end, from, count);
  }
  void read(void* to, std::size_t count) {
    if (bytes_.size() - next_ < count) throw std::logic_error("a message between ranks ends too early");
    if (count > 0) std::memcpy(to, bytes_.data() + next_, count);
    next_ += count;
  }

  std::vector<char> bytes_;
  std::size_t next_ = 0;
};

}  // namespace diefill::process::cluster
