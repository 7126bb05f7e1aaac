#include "geometry/cad/restricted_io.h"

#include <assimp/MemoryIOWrapper.h>

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <stdexcept>
#include <string_view>

#include "geometry/cad/amf_document.h"
#include "geometry/cad/cad_file.h"
#include "geometry/cad/percent_decoding.h"
#include "geometry/cad/ply_strips.h"
#include "geometry/cad/shown_text.h"

namespace diefill::geometry {

namespace {

constexpr std::size_t kShownName = 80;

/// assimp 5.2 takes no remark before the line that names the format.
std::string without_remarks_in_header(std::string bytes) {
  for (std::size_t line = 0; line < bytes.size();) {
    const std::size_t end = bytes.find('\n', line);
    const std::string_view words = std::string_view(bytes).substr(line, end - line);
    if (end == std::string::npos || words.starts_with("end_header")) break;
    if (words.starts_with("comment") || words.starts_with("obj_info"))
      bytes.erase(line, end + 1 - line);
    else
      line = end + 1;
  }
  return bytes;
}

/// assimp 5.2 takes a comment after a corner or a face for numbers.
std::string without_trailing_comments(std::string bytes) {
  for (std::size_t at = bytes.find('#'); at != std::string::npos; at = bytes.find('#', at)) {
    const std::size_t begin = at == 0 ? 0 : bytes.find_last_of("\r\n", at - 1) + 1;
    const std::string_view line = std::string_view(bytes).substr(begin, at - begin);
    const std::size_t end = std::min(bytes.find_first_of("\r\n", at), bytes.size());
    if (line.starts_with("v") || line.starts_with("f"))
      std::fill_n(bytes.begin() + static_cast<std::ptrdiff_t>(at), end - at, ' ');
    at = end;
  }
  return bytes;
}

bool is_text(const std::string& bytes) {
  return bytes.substr(0, 4096).find('\0') == std::string::npos;
}

}  // namespace

std::string with_exponents_as_e(std::string text) {
  const auto digit = [&](std::size_t k) { return std::isdigit(static_cast<unsigned char>(text[k])) != 0; };
  for (std::size_t k = text.find_first_of("dD"); k < text.size(); k = text.find_first_of("dD", k + 1)) {
    if (k == 0 || k + 2 >= text.size()) continue;
    const bool after_number = digit(k - 1) || text[k - 1] == '.';
    const bool before_sign = (text[k + 1] == '+' || text[k + 1] == '-') && digit(k + 2);
    if (after_number && before_sign) text[k] = 'e';
  }
  return text;
}

RestrictedIo::RestrictedIo(std::filesystem::path file, std::string ending)
    : file_(std::move(file)), ending_(std::move(ending)) {}

std::filesystem::path RestrictedIo::place_of(const std::string& name) const {
  std::error_code error;
  if (std::filesystem::exists(name, error)) return name;
  return percent_decoded(name);
}

std::string RestrictedIo::reason_against(const std::filesystem::path& place) const {
  std::error_code error;
  const auto folder =
      std::filesystem::canonical(file_.parent_path().empty() ? "." : file_.parent_path(), error);
  const auto target = std::filesystem::weakly_canonical(place, error);
  if (error || *target.lexically_relative(folder).begin() == "..")
    return "which is outside the folder of the CAD file: copy it there and refer to it by its file name";
  if (!std::filesystem::exists(target, error)) return "which does not exist: copy it next to the CAD file";
  if (!std::filesystem::is_regular_file(target, error)) return "which is not a regular file";
  return "";
}

bool RestrictedIo::Exists(const char* name) const {
  return name == file_.string() || (ending_.starts_with("gl") && reason_against(place_of(name)).empty());
}

std::string RestrictedIo::bytes_of_main() const {
  if (ending_ == "amf") return without_constellations(amf_document(file_));
  std::string bytes = read_cad_file(file_);
  constexpr std::string_view kMark = "\xef\xbb\xbf";
  if (bytes.starts_with(kMark)) bytes.erase(0, kMark.size());
  if (ending_ == "obj") bytes = without_trailing_comments(std::move(bytes));
  if (ending_ == "ply") bytes = without_remarks_in_header(std::move(bytes));
  const bool has_numbers = ending_ == "obj" || ending_ == "off" || ending_ == "ply";
  if (has_numbers && is_text(bytes)) bytes = with_exponents_as_e(std::move(bytes));
  return ending_ == "ply" ? with_faces_for_strips(std::move(bytes)) : bytes;
}

Assimp::IOStream* RestrictedIo::Open(const char* name, const char* mode) {
  if (name == file_.string()) {
    std::string bytes;
    try {
      bytes = bytes_of_main();
    } catch (const std::runtime_error& error) {  // whose words assimp would lose
      if (refused_.empty()) refused_ = error.what();
      return nullptr;
    }
    auto* const copy = new std::uint8_t[bytes.size()];
    std::copy(bytes.begin(), bytes.end(), copy);
    return new Assimp::MemoryIOStream(copy, bytes.size(), true);
  }
  if (!ending_.starts_with("gl")) return nullptr;
  const std::filesystem::path place = place_of(name);
  const std::string reason = reason_against(place);
  if (reason.empty()) return DefaultIOSystem::Open(place.c_str(), mode);
  // assimp puts the folder of the CAD file before the name.
  std::string written = name;
  const std::string folder = file_.parent_path().string() + "/";
  if (folder.size() > 1 && written.starts_with(folder)) written.erase(0, folder.size());
  if (refused_.empty()) refused_ = "it refers to '" + shown(written, kShownName) + "', " + reason;
  return nullptr;
}

}  // namespace diefill::geometry
