#include "process/scene/scene_text.h"

#include <toml++/toml.h>

#include <charconv>
#include <regex>
#include <sstream>
#include <stdexcept>

#include "process/input/scene_error.h"
#include "process/input/shown_value.h"
#include "process/input/syntax_hint.h"
#include "process/input/text_encoding.h"
#include "process/input/text_file.h"
#include "process/input/toml_bounds.h"

namespace diefill::process {
namespace {

constexpr std::size_t kLargestScene = 4U << 20U;  // bytes; a thousand tools take a tenth of it

std::string line_of(const std::string& text, std::size_t number) {
  std::size_t start = 0;
  for (std::size_t line = 1; line < number; ++line) {
    start = text.find('\n', start);
    if (start == std::string::npos) return {};
    ++start;
  }
  const std::size_t end = text.find_first_of("\r\n", start);
  std::string line = text.substr(start, end == std::string::npos ? end : end - start);
  const std::size_t first = line.find_first_not_of(" \t\r");
  return first == std::string::npos ? std::string()
                                    : line.substr(first, line.find_last_not_of(" \t\r") - first + 1);
}

/// The number at the end of the line with as few digits as give it back, since the library writes 0.15 as
/// 0.14999999999999999; other lines as they are.
std::string shortened(const std::string& line) {
  constexpr std::size_t kLongest = 200;  // std::regex calls itself for every character
  if (line.size() > kLongest) return line;
  static const std::regex number(R"(([A-Za-z0-9_-]+ = )(-?[0-9]+\.[0-9]+(e[-+]?[0-9]+)?))");
  std::smatch part;
  if (!std::regex_match(line, part, number)) return line;
  char digits[40];
  const auto end = std::to_chars(digits, digits + sizeof digits, std::stod(part[2])).ptr;
  const std::string text(digits, end);
  const bool whole = text.find_first_of(".e") == std::string::npos;
  return part[1].str() + text + (whole ? ".0" : "");
}

/// `called` stands in the places of all values; empty: they are of the file.
toml::table parsed(const std::string& text, const std::filesystem::path& file, const std::string& called) {
  refuse_wrong_encoding(text, file);
  refuse_deep_nesting(text, file);
  try {
    return toml::parse(text, called);
  } catch (const toml::parse_error& error) {
    const auto& at = error.source().begin;
    const std::string line = line_of(text, at.line);
    const std::string reason = one_line(error.description(), 200);
    throw SceneError(file.string() + ':' + std::to_string(at.line) + ':' + std::to_string(at.column) +
                     ": found `" + one_line(line) + "`, which is not valid TOML: " + reason +
                     (called.empty() ? syntax_hint(line, reason) : change_hint(line, reason)));
  }
}

}  // namespace

std::string load_scene_text(const std::filesystem::path& file) {
  const TextFileKind kind = {
      "scene file", "but a scene is a short TOML file; did you pass a CAD file or a result?", kLargestScene};
  try {
    return load_text_file(file, kind);
  } catch (const std::runtime_error& reason) {
    std::error_code error;
    const bool folder = std::filesystem::is_directory(file, error);
    const std::string example = folder ? "; give a scene in it, such as " + (file / "fill.toml").string()
                                       : "; give a scene file, such as sample_tools/narrow_ring/fill.toml";
    throw SceneError(file.string() + ": " + reason.what() + example);
  }
}

toml::table parse_scene_text(const std::string& text, const std::filesystem::path& file) {
  return parsed(text, file, {});
}

toml::table parse_changes(const std::string& text, const std::string& called) {
  return parsed(text, called, called);
}

std::string scene_text_of(const toml::table& document) {
  std::stringstream written;
  written << document << '\n';
  std::string text;
  for (std::string line; std::getline(written, line);) text += shortened(line) + '\n';
  return text;
}

std::string assignment_line(const std::string& key, const std::string& number, const std::string& unit) {
  return key + " = " + (unit == "1" ? number : '"' + number + ' ' + unit + '"') + '\n';
}

}  // namespace diefill::process
