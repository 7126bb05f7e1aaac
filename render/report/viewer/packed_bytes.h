// Arrays as one block of bytes that a browser unpacks, with a table of what lies where.
#pragma once

#include <QByteArray>
#include <QJsonObject>
#include <cstdint>
#include <string>
#include <vector>

namespace diefill::render::report {

/// Collects arrays. All numbers are little-endian. In the table each has `type`, `offset` (bytes) and
/// `count`.
class PackedBytes {
 public:
  void add(const std::string& name, const std::vector<std::uint8_t>& values);
  /// First all lower bytes, then all upper ones (type "u16"): deflate finds more to save.
  void add(const std::string& name, const std::vector<std::uint16_t>& values);
  void add(const std::string& name, const std::vector<std::uint32_t>& values);
  void add(const std::string& name, const std::vector<float>& values);

  const QJsonObject& table() const { return table_; }
  /// Everything, deflated in zlib's format and written as base64.
  QByteArray base64() const;

 private:
  void enter(const std::string& name, const char* type, std::size_t count);
  QByteArray bytes_;
  QJsonObject table_;
};

}  // namespace diefill::render::report
