#include "process/input/csv_file.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

#include "process/input/scene_error.h"
#include "process/input/shown_value.h"
#include "process/input/text_encoding.h"
#include "process/input/unit_conversion.h"
#include "process/input/unit_text.h"
#include "process/results/trimmed.h"

namespace diefill::process {
namespace {

/// Whether it is made of digits, signs, points and commas, one of which is a comma.
bool is_number_with_commas(const std::string& cell) {
  return cell.find(',') != std::string::npos && std::all_of(cell.begin(), cell.end(), [](char letter) {
           return std::string_view("0123456789+-,.eE").find(letter) != std::string_view::npos;
         });
}

std::string marks(char separator) {
  return separator == ';' ? "semicolons" : separator == '\t' ? "tabs" : "commas";
}

/// What to do about a text that is no number, in a table with this separator.
std::string remedy(const std::string& cell, bool out_of_range, char separator) {
  if (cell.empty()) return "nothing; give a number or remove the line";
  const std::string found = '"' + one_line(cell) + "\", ";
  if (is_number_with_commas(cell)) {
    if (std::count(cell.begin(), cell.end(), ',') > 1 || cell.find('.') != std::string::npos)
      return found + "expected one number with a decimal point and without commas, and " + marks(separator) +
             " between columns, as in the heading";
    std::string point = cell;
    point[cell.find(',')] = '.';
    return found + "a number with a decimal comma; write a decimal point, such as \"" + one_line(point) + '"';
  }
  if (out_of_range) return found + "too large or too small; allowed: 0, and 1e-307 to 1e307 in magnitude";
  return found + "expected a number with a decimal point";
}

/// What separates the columns of a table with this heading. Tabs, as in cells copied out of a spreadsheet,
/// only where nothing else does: they may also stand for blanks.
char separator_of(const std::string& heading) {
  for (const char separator : {';', ','})
    if (heading.find(separator) != std::string::npos) return separator;
  const std::string_view cells = results::trimmed(heading, " \t\r");
  return cells.find('\t') != std::string_view::npos ? '\t' : ',';
}

/// What a line such as "sep=;" says, which spreadsheets write above the heading; nothing for other lines, 0
/// for a mark that separates no columns here.
std::optional<char> stated_separator(const std::string& line) {
  constexpr std::string_view kStart = "sep=";
  const std::size_t first = line.find_first_not_of(" \t\"");
  if (first == std::string::npos || line.size() < first + kStart.size()) return std::nullopt;
  for (std::size_t k = 0; k < kStart.size(); ++k)
    if (std::tolower(static_cast<unsigned char>(line[first + k])) != kStart[k]) return std::nullopt;
  const std::size_t at = first + kStart.size();
  const bool known = at < line.size() && std::string_view(";,\t").find(line[at]) != std::string_view::npos;
  return known ? line[at] : '\0';
}

/// Another separator than `separator` that a line of `cells` cells has; 0 where there is none.
char other_separator(const std::string& line, char separator, std::size_t cells) {
  for (const char other : {';', ',', '\t'})
    if (other != separator && (other != '\t' || cells == 1) && line.find(other) != std::string::npos)
      return other;
  return 0;
}

/// Where the name in a heading ends; npos where no unit follows it.
std::size_t end_of_name(const std::string& cell) {
  if (const std::size_t bracket = cell.rfind('['); bracket != std::string::npos) return bracket;
  if (const std::size_t bracket = cell.rfind('('); bracket != std::string::npos) return bracket;
  constexpr const char* kBlanks = " \t";
  const std::size_t first = cell.find_first_of(kBlanks);
  for (std::size_t blank = first; blank != std::string::npos;
       blank = cell.find_first_of(kBlanks, blank + 1)) {
    const std::string behind = trimmed_cell(cell.substr(blank));
    if (!behind.empty() && has_same_dimension(behind, behind)) return blank;
  }
  return first;
}

}  // namespace

std::string trimmed_cell(const std::string& text) {
  return std::string(results::trimmed(text, " \t\r\""));
}

CsvHeading csv_heading(const std::string& cell) {
  const std::size_t end = end_of_name(cell);
  if (end == std::string::npos) return {cell, ""};
  std::string unit = cell.substr(end);
  std::erase_if(unit, [](char c) { return c == '[' || c == ']' || c == '(' || c == ')'; });
  return {trimmed_cell(cell.substr(0, end)), trimmed_cell(unit)};
}

CsvFile::CsvFile(const std::filesystem::path& file, const TextFileKind& kind, std::string before)
    : file_(file.string()), before_(std::move(before)), text_(load_text_file(file, kind)) {
  constexpr std::string_view kMark = "\xEF\xBB\xBF";
  try {
    refuse_wrong_encoding(text_, file, TextKind::csv);
  } catch (const SceneError& error) {
    throw SceneError(before_ + error.what());
  }
  if (text_.starts_with(kMark)) at_ = kMark.size();
}

std::string CsvFile::place() const {
  return before_ + file_ + ':' + std::to_string(line_);
}

std::string CsvFile::place(std::size_t cell) const {
  return place() + ':' + std::to_string(starts_.at(cell));
}

bool CsvFile::next_line(std::string& line) {
  if (at_ >= text_.size()) return false;
  const std::size_t end = std::min(text_.find_first_of("\r\n", at_), text_.size());
  line.assign(text_, at_, end - at_);
  at_ = end + (text_.compare(end, 2, "\r\n") == 0 ? 2 : 1);
  ++line_;
  return true;
}

bool CsvFile::next() {
  for (std::string line; next_line(line);) {
    if (line.find_first_not_of(" \t\",;") == std::string::npos) continue;
    if (trimmed_cell(line).front() == '#') continue;
    if (columns_ == 0) {
      if (const auto stated = stated_separator(line)) {
        separator_ = *stated;
        continue;
      }
    }
    if (separator_ == 0) separator_ = separator_of(line);
    split(line);
    check_count(line);
    return true;
  }
  return false;
}

void CsvFile::split(const std::string& line) {
  cells_.clear();
  starts_.clear();
  for (std::size_t begin = 0; begin <= line.size();) {
    const std::size_t first = line.find_first_not_of(separator_ == '\t' ? " " : " \t", begin);
    std::size_t end = begin;
    if (first != std::string::npos && line[first] == '"') {
      const std::size_t quote = line.find('"', first + 1);
      if (quote != std::string::npos) end = quote;
    }
    end = std::min(line.find(separator_, end), line.size());
    cells_.push_back(trimmed_cell(line.substr(begin, end - begin)));
    starts_.push_back((first == std::string::npos || first > end ? begin : first) + 1);
    begin = end + 1;
  }
}

void CsvFile::check_count(const std::string& line) {
  // Spreadsheets leave separators at the end of a line.
  while (cells_.size() > std::max<std::size_t>(columns_, 1) && cells_.back().empty()) {
    cells_.pop_back();
    starts_.pop_back();
  }
  if (columns_ == 0) columns_ = cells_.size();
  if (cells_.size() != columns_) refuse_count(line);
}

void CsvFile::refuse_count(const std::string& line) const {
  std::string hint;
  const char other = other_separator(line, separator_, cells_.size());
  const bool whole = std::all_of(cells_.begin(), cells_.end(), [](const std::string& cell) {
    return !cell.empty() && cell.find_first_not_of("+-0123456789") == std::string::npos;
  });
  if (other != 0)
    hint = ": the heading separates columns by " + marks(separator_) + ", this line has " + marks(other) +
           "; use one of them throughout, and decimal points";
  else if (separator_ == ',' && whole && cells_.size() > columns_)
    hint = "; if these are decimal commas, write decimal points";
  throw SceneError(place() + ": found " + std::to_string(cells_.size()) + " values, expected " +
                   std::to_string(columns_) + ", one per column" + hint);
}

double CsvFile::number(std::size_t cell, const std::string& column) const {
  const std::string& found = cells_.at(cell);
  const bool plain = std::all_of(found.begin(), found.end(), [](char letter) { return letter > 0; });
  const std::string typed = plain ? found : as_typed(found);
  const std::size_t sign = typed.starts_with('+') && !typed.starts_with("+-") ? 1 : 0;
  double value = 0;
  const char* const end = typed.data() + typed.size();
  const auto [last, error] = std::from_chars(typed.data() + sign, end, value);
  const bool out_of_range = error == std::errc::result_out_of_range && last == end;
  if (error != std::errc() || last != end || !std::isfinite(value))
    throw SceneError(place(cell) + (column.empty() ? "" : ": column " + column) + ": found " +
                     remedy(found, out_of_range, separator_));
  return value;
}

void CsvFile::refuse_twice(const std::vector<std::string>& keys) const {
  for (std::size_t k = 0; k < keys.size(); ++k)
    if (std::find(keys.begin(), keys.begin() + static_cast<std::ptrdiff_t>(k), keys[k]) !=
        keys.begin() + static_cast<std::ptrdiff_t>(k))
      throw SceneError(place(k) + ": found column " + one_line(keys[k]) + " twice; remove one of them");
}

}  // namespace diefill::process
