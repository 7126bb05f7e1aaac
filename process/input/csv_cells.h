// Lines of CSV tables that users write by hand or export: numbers and headings, without separators in quotes.
#pragma once

#include <string>
#include <vector>

namespace diefill::process {

/// The text without blanks, quotes and carriage returns at both ends.
std::string trimmed_cell(const std::string& text);

/// Trimmed cells of a line. A separator at its end, as spreadsheets leave it, begins no further cell.
std::vector<std::string> csv_cells(const std::string& line, char separator = ',');

}  // namespace diefill::process
