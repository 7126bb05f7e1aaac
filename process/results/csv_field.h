// Texts and numbers as fields of a CSV file.
#pragma once

#include <cmath>
#include <cstdio>
#include <string>

namespace diefill::results {

/// In quotation marks, those within doubled.
inline std::string csv_text(const std::string& text) {
  std::string field = "\"";
  for (const char letter : text) field += letter == '"' ? "\"\"" : std::string(1, letter);
  return field + '"';
}

/// With so many significant digits; empty where there is no value.
inline std::string csv_number(double value, int digits = 9) {
  if (!std::isfinite(value)) return {};
  char text[40];
  std::snprintf(text, sizeof text, "%.*g", digits, value);
  return text;
}

}  // namespace diefill::results
