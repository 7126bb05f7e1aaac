// CSV tables that users write by hand or export: a heading, then rows of numbers, each with its place in the
// file for messages. Every table that a user hands over is read here.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "process/input/text_file.h"

namespace diefill::process {

/// The text without blanks, quotes and carriage returns at both ends.
std::string trimmed_cell(const std::string& text);

/// A heading such as "mass [g]", "mass (g)" or "mass g".
struct CsvHeading {
  std::string name, unit;  ///< unit empty where none is given
};

/// Splits at the last bracket. Without brackets at the first blank with a known unit behind it ("filled mass
/// kg"), or at the first blank where no unit is known.
CsvHeading csv_heading(const std::string& cell);

/// Walks through a table line by line. Commas, semicolons or tabs separate cells, whichever the heading has;
/// a cell in quotes may hold them. Empty lines and lines that begin with # are passed over, a byte order
/// mark, and a line such as "sep=;" above the heading, which names the separator.
class CsvFile {
 public:
  /// Throws std::runtime_error as load_text_file() does, and SceneError for text that is not UTF-8. `before`
  /// begins each message, such as the key of a scene that names the file.
  CsvFile(const std::filesystem::path& file, const TextFileKind& kind, std::string before = {});

  /// Goes to the next line; the first one is the heading. False at the end of the file. Throws SceneError for
  /// a line with another number of cells than the heading.
  bool next();

  const std::vector<std::string>& cells() const { return cells_; }
  int line() const { return line_; }
  /// "file:line" of the line, and "file:line:column" of a cell.
  std::string place() const;
  std::string place(std::size_t cell) const;
  /// Throws SceneError unless the cell is a finite number; `column` names the column where not empty.
  double number(std::size_t cell, const std::string& column = {}) const;
  /// Throws SceneError at the second of two columns of the heading whose keys are the same. To be called
  /// while the heading is the current line.
  void refuse_twice(const std::vector<std::string>& keys) const;

 private:
  bool next_line(std::string& line);
  void split(const std::string& line);
  void check_count(const std::string& line);
  [[noreturn]] void refuse_count(const std::string& line) const;

  std::string file_, before_, text_;
  std::size_t at_ = 0, columns_ = 0;
  int line_ = 0;
  char separator_ = 0;  ///< 0 before the heading
  std::vector<std::string> cells_;
  std::vector<std::size_t> starts_;  ///< bytes from the line's beginning, from 1
};

}  // namespace diefill::process
