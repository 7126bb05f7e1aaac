#include "process/measured_data/deviations.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <string_view>

#include "process/input/scene_error.h"
#include "process/input/shown_value.h"
#include "process/input/unit_conversion.h"

namespace diefill::process {
namespace {

constexpr std::array<std::string_view, 6> kWords = {"std", "stdev", "stddev", "sd", "error", "uncertainty"};

std::string lower_case(std::string text) {
  for (char& letter : text) letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  return text;
}

/// Whether the word stands in the text between other characters than letters.
bool has_word(const std::string& text, std::string_view word) {
  const auto is_letter = [&](std::size_t at) {
    return at < text.size() && std::isalpha(static_cast<unsigned char>(text[at])) != 0;
  };
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1))
    if ((at == 0 || !is_letter(at - 1)) && !is_letter(at + word.size())) return true;
  return false;
}

/// Nobody calls anything else so.
bool is_called_deviation(const MeasuredColumn& column) {
  return lower_case(column.name).find("deviation") != std::string::npos;
}

/// Where a point's deviation stands: the line of the file, or its own key.
std::string place_of_deviation(const MeasuredTable& table, std::size_t point) {
  if (!table.lines.empty()) return table.where_of(point);
  return table.deviation.where + (table.size() > 1 ? ": point " + std::to_string(point + 1) : "");
}

/// Range of the deviations that values may have.
struct Allowed {
  double least, most;
  const char* why;  ///< in terms of the values; behind the numbers
};

Allowed allowed_beside(const std::vector<double>& values) {
  constexpr double kOfLargest = 1e9, kWithoutValue = 1e30;  // the latter where all values are 0
  double largest = 0;
  for (const double value : values) largest = std::max(largest, std::abs(value));
  if (largest > 0)
    return {largest / kOfLargest, largest * kOfLargest, ", which is 1e-9 to 1e9 times the largest value"};
  return {1 / kWithoutValue, kWithoutValue, ""};
}

}  // namespace

bool is_deviation(const MeasuredColumn& column) {
  if (is_called_deviation(column)) return true;
  const std::string name = lower_case(column.name);
  if (has_word(name, "sigma") || name.find("\xCF\x83") != std::string::npos)  // a small sigma
    return !has_same_dimension(column.unit, "Pa");
  return std::any_of(kWords.begin(), kWords.end(),
                     [&](std::string_view word) { return has_word(name, word); });
}

std::optional<MeasuredColumn> taken_deviation(std::vector<MeasuredColumn>& columns) {
  const bool called = std::any_of(columns.begin(), columns.end(), is_called_deviation);
  const auto meant = called ? is_called_deviation : is_deviation;
  const auto found = std::find_if(columns.begin(), columns.end(), meant);
  if (found == columns.end()) return std::nullopt;
  MeasuredColumn deviation = std::move(*found);
  columns.erase(found);
  if (has_word(lower_case(deviation.name), "relative"))
    throw SceneError(deviation.where + ": found \"" + one_line(deviation.name) +
                     "\"; give deviations in the unit of the values");
  const auto second = std::find_if(columns.begin(), columns.end(), meant);
  if (second != columns.end())
    throw SceneError(second->where + ": found a second column of deviations, \"" + one_line(second->name) +
                     "\"; remove one of them" + (called ? "" : ", or call the right one \"deviation\""));
  return deviation;
}

void convert_deviation(MeasuredColumn& deviation, const MeasuredColumn& value) {
  try {
    const double factor = unit_factor(deviation.unit, value.unit);
    for (double& number : deviation.values) number *= factor;
    deviation.unit = value.unit;
  } catch (const UnitError& error) {
    throw SceneError(deviation.where + ": deviation in \"" + deviation.unit + "\", value in \"" + value.unit +
                     "\": " + error.what() + "; give both with their unit");
  }
}

void check_deviations(const MeasuredTable& table) {
  const Allowed allowed = allowed_beside(table.value.values);
  const std::string unit = table.value.unit == "1" ? "" : ' ' + table.value.unit;
  for (std::size_t k = 0; k < table.size(); ++k) {
    const double deviation = table.deviation.values[k];
    const std::string found =
        place_of_deviation(table, k) + ": the standard deviation is " + number_text(deviation);
    if (!(deviation > 0))
      throw SceneError(found +
                       ", allowed: more than 0; give the standard deviation of repeated measurements");
    if (deviation < allowed.least || deviation > allowed.most)
      throw SceneError(found + unit + ", allowed: " + number_text(allowed.least) + " to " +
                       number_text(allowed.most) + unit + allowed.why + "; check the number and its unit");
  }
}

std::string remark_on_deviations(const MeasuredTable& table) {
  std::size_t larger = 0;
  for (std::size_t k = 0; k < table.size(); ++k)
    larger += table.deviation.values[k] > std::abs(table.value.values[k]) ? 1 : 0;
  if (2 * larger <= table.size()) return {};
  return (table.size() == 1 ? std::string("its deviation exceeds its value")
                            : std::to_string(larger) + " of its " + std::to_string(table.size()) +
                                  " deviations exceed their values") +
         "; check that value and deviation are not swapped";
}

}  // namespace diefill::process
