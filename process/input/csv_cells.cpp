#include "process/input/csv_cells.h"

#include <sstream>

namespace diefill::process {

std::string trimmed_cell(const std::string& text) {
  const char* const passed_over = " \t\r\"";
  const std::size_t first = text.find_first_not_of(passed_over);
  if (first == std::string::npos) return {};
  return text.substr(first, text.find_last_not_of(passed_over) - first + 1);
}

std::vector<std::string> csv_cells(const std::string& line, char separator) {
  std::vector<std::string> cells;
  std::istringstream stream(line);
  for (std::string cell; std::getline(stream, cell, separator);) cells.push_back(trimmed_cell(cell));
  return cells;
}

}  // namespace diefill::process
