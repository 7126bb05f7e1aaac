#include "process/input/text_file.h"

#include <fstream>
#include <stdexcept>
#include <system_error>

namespace diefill::process {
namespace {

namespace fs = std::filesystem;

constexpr std::streamsize kPart = std::streamsize{1} << 20;  // bytes

[[noreturn]] void refuse(const std::string& reason) {
  throw std::runtime_error(reason);
}

std::string description(std::size_t bytes) {
  return std::to_string(bytes >> 20U) + " MiB";
}

void refuse_unless_regular(const fs::path& file, const TextFileKind& kind) {
  std::error_code error;
  const auto status = fs::status(file, error);
  if (status.type() == fs::file_type::none)
    refuse("the file cannot be accessed (" + error.message() + "); check its path and permissions");
  if (!fs::exists(status))
    refuse("found no such " + kind.called + " (looked for " +
           fs::absolute(file, error).lexically_normal().string() + ')');
  if (fs::is_directory(status)) refuse("found a folder, expected a " + kind.called);
  if (!fs::is_regular_file(status)) refuse("found a device, pipe or socket, expected a regular file");
}

}  // namespace

std::string load_text_file(const fs::path& file, const TextFileKind& kind) {
  refuse_unless_regular(file, kind);
  const std::string too_large =
      "found a file of more than " + description(kind.largest) + ", " + kind.description;
  std::error_code error;
  if (fs::file_size(file, error) > kind.largest && !error) refuse(too_large);
  std::ifstream stream(file, std::ios::binary);
  // Read in parts: the limit may be gigabytes, and the size reported above may be out of date.
  std::string text, part(static_cast<std::size_t>(kPart), '\0');
  while (stream.read(part.data(), kPart) || stream.gcount() > 0) {
    text.append(part, 0, static_cast<std::size_t>(stream.gcount()));
    if (text.size() > kind.largest) refuse(too_large);
  }
  if (stream.bad() || !stream.eof()) refuse("the file cannot be read; check its permissions");
  return text;
}

}  // namespace diefill::process
