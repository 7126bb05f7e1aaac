#include "process/press_mesh/mesh_lines.h"

#include <charconv>
#include <cmath>
#include <stdexcept>

#include "process/input/scene_error.h"
#include "process/input/text_file.h"
#include "process/results/trimmed.h"

namespace diefill::process {
namespace {

constexpr std::size_t kLargest = std::size_t{2} << 30;  // bytes
constexpr std::size_t kShown = 60;                      // letters of a line in messages
constexpr const char* kBlanks = " \t\r\n\f\v";

}  // namespace

MeshLines::MeshLines(const std::filesystem::path& file) : name_(file.string()) {
  try {
    text_ = load_text_file(file, {"mesh file", "a finite-element mesh is one text file", kLargest});
  } catch (const std::runtime_error& reason) {
    throw SceneError(name_ + ": " + reason.what());
  }
  constexpr std::string_view kMark = "\xEF\xBB\xBF";
  if (text_.starts_with(kMark)) place_ = kMark.size();
  // Comments may be in any encoding of single bytes.
  constexpr std::size_t kFirst = 4;
  if (text_.starts_with("\xFF\xFE") || text_.starts_with("\xFE\xFF") ||
      std::string_view(text_).substr(0, kFirst).find('\0') != std::string_view::npos)
    throw SceneError(name_ + ":1: found UTF-16 text, expected UTF-8; save the mesh as UTF-8 text");
}

bool MeshLines::next() {
  if (again_) {
    again_ = false;
    return true;
  }
  while (place_ < text_.size()) {
    const std::size_t end = std::min(text_.find('\n', place_), text_.size());
    line_ = results::trimmed(std::string_view(text_).substr(place_, end - place_), kBlanks);
    place_ = end + 1;
    ++number_;
    if (!line_.empty()) return true;
  }
  return false;
}

std::string_view MeshLines::require(const std::string& wanted) {
  if (!next())
    throw SceneError(name_ + ": the file ends after line " + std::to_string(number_) + ", expected " +
                     wanted + "; write the mesh again");
  return line_;
}

void MeshLines::reject(const std::string& expected) const {
  std::string shown(line_.substr(0, kShown));
  if (line_.size() > kShown) shown += "...";
  reject_text("found \"" + shown + "\", expected " + expected);
}

void MeshLines::reject_text(const std::string& message) const {
  throw SceneError(name_ + ":" + std::to_string(number_) + ": " + message);
}

std::vector<std::string_view> cells_of_line(std::string_view line, bool comma) {
  std::vector<std::string_view> cells;
  while (!line.empty()) {
    if (!comma) {
      const std::size_t first = line.find_first_not_of(kBlanks);
      if (first == std::string_view::npos) break;
      line.remove_prefix(first);
    }
    const std::size_t end = std::min(line.find_first_of(comma ? "," : kBlanks), line.size());
    cells.push_back(results::trimmed(line.substr(0, end), kBlanks));
    line.remove_prefix(std::min(end + 1, line.size()));
  }
  return cells;
}

std::uint64_t whole_number(std::string_view cell, const MeshLines& lines) {
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  if (error != std::errc() || end != cell.data() + cell.size() || cell.empty())
    lines.reject_text("found \"" + std::string(cell.substr(0, kShown)) +
                      "\", expected a whole number from 0");
  return value;
}

double decimal_number(std::string_view cell, const MeshLines& lines) {
  std::string_view digits = cell;
  if (digits.starts_with('+') && !digits.starts_with("+-")) digits.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error == std::errc::result_out_of_range)
    lines.reject_text("found \"" + std::string(cell.substr(0, kShown)) +
                      "\", a number that is too large or too small");
  if (error != std::errc() || end != digits.data() + digits.size() || digits.empty() || !std::isfinite(value))
    lines.reject_text("found \"" + std::string(cell.substr(0, kShown)) + "\", expected a number");
  return value;
}

}  // namespace diefill::process
