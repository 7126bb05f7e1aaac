#include "geometry/cad/unit_of_3mf.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "geometry/cad/shown_text.h"

namespace diefill::geometry {

namespace {

constexpr std::size_t kHead = 1U << 16U;  // bytes of a model within which its first tag ends
constexpr std::array<std::string_view, 6> kUnits = {"micron", "millimeter", "centimeter",
                                                    "inch",   "foot",       "meter"};  // of 3MF
constexpr std::string_view kBlanks = " \t\r\n";

/// A little-endian number of `count` bytes; 0 beyond the end.
std::uint32_t number_at(std::string_view bytes, std::size_t place, int count) {
  if (place + static_cast<std::size_t>(count) > bytes.size()) return 0;
  std::uint32_t number = 0;
  for (int k = count - 1; k >= 0; --k)
    number = number << 8U | static_cast<unsigned char>(bytes[place + static_cast<std::size_t>(k)]);
  return number;
}

/// The beginning of what was deflated without a header, as archives have it.
std::string inflated(std::string_view packed) {
  std::string head(kHead, '\0');
  z_stream stream = {};
  if (inflateInit2(&stream, -MAX_WBITS) != Z_OK) return {};
  std::vector<unsigned char> input(packed.begin(), packed.end());
  stream.next_in = input.data();
  stream.avail_in = static_cast<uInt>(input.size());
  stream.next_out = reinterpret_cast<unsigned char*>(head.data());
  stream.avail_out = static_cast<uInt>(head.size());
  inflate(&stream, Z_SYNC_FLUSH);
  head.resize(head.size() - stream.avail_out);
  inflateEnd(&stream);
  return head;
}

/// The beginning of an entry, stored or deflated; empty where it is packed in another way.
std::string head_of_entry(std::string_view bytes, std::size_t local, std::uint32_t packed_size) {
  constexpr std::size_t kHeader = 30;
  if (local > bytes.size() || bytes.size() - local < kHeader) return {};
  const std::uint32_t method = number_at(bytes, local + 8, 2);
  const std::size_t start =
      local + kHeader + number_at(bytes, local + 26, 2) + number_at(bytes, local + 28, 2);
  if (start > bytes.size()) return {};
  // A model that does not compress has its first tag within the first bytes, too.
  const std::string_view packed = bytes.substr(start, std::min<std::size_t>(packed_size, 2 * kHead));
  if (method == 0) return std::string(packed.substr(0, kHead));
  return method == Z_DEFLATED ? inflated(packed) : std::string();
}

/// Value of the attribute `unit` in the tag `model`; empty where it has none.
std::string_view stated_unit(std::string_view xml) {
  std::size_t tag = xml.find("model");
  while (tag != std::string_view::npos && tag > 0 && xml[tag - 1] != '<' && xml[tag - 1] != ':')
    tag = xml.find("model", tag + 1);
  if (tag == std::string_view::npos) return {};
  const std::string_view inside = xml.substr(tag, xml.find('>', tag) - tag);
  for (std::size_t at = inside.find("unit"); at != std::string_view::npos; at = inside.find("unit", at + 1)) {
    if (at == 0 || kBlanks.find(inside[at - 1]) == std::string_view::npos) continue;
    std::size_t next = inside.find_first_not_of(kBlanks, at + 4);
    if (next == std::string_view::npos || inside[next] != '=') continue;
    next = inside.find_first_not_of(kBlanks, next + 1);
    if (next == std::string_view::npos || (inside[next] != '"' && inside[next] != '\'')) continue;
    const std::size_t end = inside.find(inside[next], next + 1);
    if (end != std::string_view::npos) return inside.substr(next + 1, end - next - 1);
  }
  return {};
}

void refuse_unknown(std::string_view unit) {
  if (unit.empty() || std::find(kUnits.begin(), kUnits.end(), unit) != kUnits.end()) return;
  std::string allowed;
  for (const std::string_view known : kUnits) allowed += (allowed.empty() ? "" : ", ") + std::string(known);
  throw std::runtime_error("its unit is '" + shown(std::string(unit), 40) + "', allowed: " + allowed);
}

}  // namespace

void refuse_unknown_unit_of_3mf(const std::string& archive) {
  const std::string_view bytes = archive;
  const std::size_t end = bytes.rfind("PK\x05\x06");
  if (end == std::string_view::npos) return;
  std::size_t entry = number_at(bytes, end + 16, 4);
  const std::uint32_t entries = number_at(bytes, end + 10, 2);
  constexpr std::size_t kEntry = 46;
  for (std::uint32_t k = 0; k < entries && entry + kEntry <= bytes.size(); ++k) {
    const std::uint32_t packed = number_at(bytes, entry + 20, 4), name = number_at(bytes, entry + 28, 2);
    if (bytes.substr(entry + kEntry, name).ends_with(".model"))
      refuse_unknown(stated_unit(head_of_entry(bytes, number_at(bytes, entry + 42, 4), packed)));
    entry += kEntry + name + number_at(bytes, entry + 30, 2) + number_at(bytes, entry + 32, 2);
  }
}

}  // namespace diefill::geometry
