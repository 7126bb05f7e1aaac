// The lines of a mesh file, with messages that name file and line.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace diefill::process {

/// Reads line after line; lines are without blanks at both ends.
class MeshLines {
 public:
  /// Throws SceneError where the file cannot be read.
  explicit MeshLines(const std::filesystem::path& file);

  /// The next line that is not empty; false at the end.
  bool next();
  /// The same where a line must follow; `wanted` says which, such as "a node".
  std::string_view require(const std::string& wanted);
  /// The current line is read again by the next call.
  void put_back() { again_ = true; }

  std::string_view line() const { return line_; }
  /// Throws SceneError "file:line: found "...", `expected`" about the current line.
  [[noreturn]] void reject(const std::string& expected) const;
  /// The same about a part of the line, or with a text of its own.
  [[noreturn]] void reject_text(const std::string& message) const;

 private:
  std::string name_, text_;
  std::size_t place_ = 0;
  int number_ = 0;
  bool again_ = false;
  std::string_view line_;
};

/// Cells of a line between blanks, or between commas where `comma`; a comma at the end begins no cell.
std::vector<std::string_view> cells_of_line(std::string_view line, bool comma);

/// Whole number from 0, or a decimal number; SceneError through `lines` for anything else.
std::uint64_t whole_number(std::string_view cell, const MeshLines& lines);
double decimal_number(std::string_view cell, const MeshLines& lines);

}  // namespace diefill::process
