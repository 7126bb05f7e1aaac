#include "process/scene/scene_text.h"

#include <toml++/toml.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <fstream>
#include <iterator>
#include <regex>
#include <sstream>

#include "process/scene/scene_error.h"
#include "process/scene/shown_value.h"

namespace diefill::process {
namespace {

constexpr std::uintmax_t kLargestScene = 4U << 20U;  // bytes; a thousand tools take a tenth of it

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& reason) {
  throw SceneError(file.string() + ": " + reason);
}

/// A file of bytes below space other than tab and line ends is no text, whatever its name says.
void check_is_text(const std::string& text, const std::filesystem::path& file) {
  std::size_t line = 1;
  for (const char letter : text) {
    const auto code = static_cast<unsigned char>(letter);
    if (letter == '\n') ++line;
    if (code >= 0x20 || letter == '\n' || letter == '\r' || letter == '\t') continue;
    throw SceneError(file.string() + ':' + std::to_string(line) + ": found the byte " +
                     std::to_string(int{code}) +
                     ", this is not a text file; a scene is a TOML text saved as UTF-8");
  }
}

std::string line_of(const std::string& text, std::size_t number) {
  std::size_t start = 0;
  for (std::size_t line = 1; line < number; ++line) {
    start = text.find('\n', start);
    if (start == std::string::npos) return {};
    ++start;
  }
  const std::size_t end = text.find('\n', start);
  std::string line = text.substr(start, end == std::string::npos ? end : end - start);
  const std::size_t first = line.find_first_not_of(" \t\r");
  return first == std::string::npos ? std::string()
                                    : line.substr(first, line.find_last_not_of(" \t\r") - first + 1);
}

/// What was probably meant on a line that is not TOML.
std::string syntax_remedy(const std::string& line, const std::string& reason) {
  if (reason.find("cannot redefine") != std::string::npos)
    return "; it is given above already, keep one of the two";
  if (line.starts_with('[') && line.find(']') == std::string::npos)
    return "; close the bracket, such as " + line + ']';
  if (std::count(line.begin(), line.end(), '"') % 2 != 0) return "; close the quote";
  const std::size_t equals = line.find('=');
  if (equals == std::string::npos) return "; each line is key = value, [table] or # comment";
  const std::size_t start = line.find_first_not_of(" \t", equals + 1);
  if (start == std::string::npos) return "; the value is missing after \"=\"";
  const std::string key = line.substr(0, line.find_last_not_of(" \t", equals - 1) + 1),
                    value = line.substr(start);
  const auto digit = [](char letter) { return std::isdigit(static_cast<unsigned char>(letter)) != 0; };
  const auto letter = [](char c) {
    return std::isalpha(static_cast<unsigned char>(c)) != 0 || (c & 0x80) != 0;
  };
  const std::size_t after_number = value.find_first_not_of("+-0123456789.eE");
  if (digit(value.front()) || value.front() == '-' || value.front() == '+' || value.front() == '.') {
    if (after_number != std::string::npos && value[after_number] == ',')
      return "; write a decimal point, not a comma";
    const std::size_t unit = value.find_first_not_of(" \t", after_number);
    if (unit != std::string::npos && letter(value[unit])) {
      return "; a quantity with its unit stands in quotes, such as " + key + " = \"" +
             one_line(value.substr(0, value.find(" #"))) + '"';
    }
    if (value.front() == '.') return "; write a digit before the decimal point, such as 0" + one_line(value);
  }
  if (letter(value.front()))
    return "; text stands in quotes, such as " + key + " = \"" + one_line(value) + '"';
  if (line.find('\\') != std::string::npos) return "; in a path write / instead of \\";
  return {};
}

/// The number at the end of the line with as few digits as give it back, since the library writes 0.15 as
/// 0.14999999999999999; other lines as they are.
std::string shortened(const std::string& line) {
  static const std::regex number(R"(([A-Za-z0-9_-]+ = )(-?[0-9]+\.[0-9]+(e[-+]?[0-9]+)?))");
  std::smatch part;
  if (!std::regex_match(line, part, number)) return line;
  char digits[40];
  const auto end = std::to_chars(digits, digits + sizeof digits, std::stod(part[2])).ptr;
  const std::string text(digits, end);
  const bool whole = text.find_first_of(".e") == std::string::npos;
  return part[1].str() + text + (whole ? ".0" : "");
}

}  // namespace

std::string load_scene_text(const std::filesystem::path& file) {
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  if (!std::filesystem::exists(status)) {
    refuse(file, "found no such scene file (looked for " +
                     std::filesystem::absolute(file, error).lexically_normal().string() +
                     "); give the path of a scene, such as sample_tools/narrow_ring/fill.toml");
  }
  if (std::filesystem::is_directory(status)) {
    refuse(file, "found a folder, a scene file is needed; give the path of a scene in it, such as " +
                     (file / "fill.toml").string());
  }
  if (!std::filesystem::is_regular_file(status))
    refuse(file, "found no regular file, a scene file (TOML text) is needed");
  if (std::filesystem::file_size(file, error) > kLargestScene || error) {
    refuse(
        file,
        "found a file of more than 4 MiB, a scene is a short TOML text; is this the CAD file or a result?");
  }
  std::ifstream stream(file, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  if (!stream && !stream.eof()) refuse(file, "the file cannot be read; check its permissions");
  return text;
}

toml::table parse_scene_text(const std::string& text, const std::filesystem::path& file) {
  check_is_text(text, file);
  try {
    return toml::parse(text);
  } catch (const toml::parse_error& error) {
    const auto& at = error.source().begin;
    const std::string line = line_of(text, at.line);
    const std::string reason = one_line(error.description(), 200);
    const bool bad_encoding = reason.find("utf-8") != std::string::npos;
    throw SceneError(file.string() + ':' + std::to_string(at.line) + ':' + std::to_string(at.column) + ": " +
                     (bad_encoding ? "found bytes that are not UTF-8; save the scene as UTF-8 text"
                                   : "found `" + one_line(line) + "`, which is not TOML: " + reason +
                                         syntax_remedy(line, reason)));
  }
}

std::string scene_text_of(const toml::table& document) {
  std::stringstream written;
  written << document << '\n';
  std::string text;
  for (std::string line; std::getline(written, line);) text += shortened(line) + '\n';
  return text;
}

}  // namespace diefill::process
