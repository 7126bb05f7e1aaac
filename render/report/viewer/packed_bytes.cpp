#include "render/report/viewer/packed_bytes.h"

#include <cstring>

namespace diefill::render::report {
namespace {

constexpr qsizetype kAlignment = 4;  // bytes: where a browser may view an array of numbers in place

void append_word(QByteArray& bytes, std::uint32_t word) {
  for (int shift = 0; shift < 32; shift += 8) bytes.append(static_cast<char>((word >> shift) & 0xFFU));
}

}  // namespace

void PackedBytes::enter(const std::string& name, const char* type, std::size_t count) {
  while (bytes_.size() % kAlignment != 0) bytes_.append('\0');
  table_[QString::fromStdString(name)] = QJsonObject{
      {"type", type}, {"offset", static_cast<qint64>(bytes_.size())}, {"count", static_cast<qint64>(count)}};
}

void PackedBytes::add(const std::string& name, const std::vector<std::uint8_t>& values) {
  enter(name, "u8", values.size());
  for (const std::uint8_t value : values) bytes_.append(static_cast<char>(value));
}

void PackedBytes::add(const std::string& name, const std::vector<std::uint16_t>& values) {
  enter(name, "u16", values.size());
  for (const std::uint16_t value : values) bytes_.append(static_cast<char>(value & 0xFFU));
  for (const std::uint16_t value : values) bytes_.append(static_cast<char>(value >> 8U));
}

void PackedBytes::add(const std::string& name, const std::vector<std::uint32_t>& values) {
  enter(name, "u32", values.size());
  for (const std::uint32_t value : values) append_word(bytes_, value);
}

void PackedBytes::add(const std::string& name, const std::vector<float>& values) {
  enter(name, "f32", values.size());
  for (const float value : values) {
    std::uint32_t word = 0;
    static_assert(sizeof word == sizeof value);
    std::memcpy(&word, &value, sizeof word);
    append_word(bytes_, word);
  }
}

QByteArray PackedBytes::base64() const {
  constexpr qsizetype kLength = 4;  // Qt puts the length before the stream
  return qCompress(bytes_, 9).mid(kLength).toBase64();
}

}  // namespace diefill::render::report
