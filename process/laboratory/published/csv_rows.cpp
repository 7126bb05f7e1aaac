#include "process/laboratory/published/csv_rows.h"

#include <cstdlib>
#include <fstream>
#include <limits>
#include <sstream>

#include "process/input/scene_error.h"
#include "process/laboratory/published/csv_fields.h"
#include "process/results/csv_field.h"

namespace diefill::process::laboratory {
namespace {

double number_as(const std::string& field, const std::string& where, const char* expected) {
  char* end = nullptr;
  const double value = std::strtod(field.c_str(), &end);
  if (end == field.c_str() || *end != '\0')
    throw SceneError(where + ": found \"" + field + "\", expected " + expected);
  return value;
}

}  // namespace

void for_each_row(
    const std::filesystem::path& file, std::size_t columns, MissingFile missing,
    const std::function<void(const std::vector<std::string>& fields, const std::string& where)>& use,
    std::size_t optional) {
  std::ifstream stream(file);
  if (!stream && missing == MissingFile::error)
    throw SceneError(file.string() +
                     ": cannot be read; give the folder of the laboratory's scenes with --scenes");
  std::string line;
  std::getline(stream, line);
  for (int number = 2; std::getline(stream, line); ++number) {
    const std::string where = file.string() + ':' + std::to_string(number);
    const auto fields = csv_fields(line);
    if (fields.size() > columns || fields.size() + optional < columns)
      throw SceneError(where + ": found " + std::to_string(fields.size()) + " fields, expected " +
                       std::to_string(columns));
    use(fields, where);
  }
}

double number_in(const std::string& field, const std::string& where) {
  return number_as(field, where, "a number");
}

double number_or_nothing_in(const std::string& field, const std::string& where) {
  if (field.empty()) return std::numeric_limits<double>::quiet_NaN();
  return number_as(field, where, "a number or nothing");
}

std::vector<double> numbers_in(const std::string& field, const std::string& where) {
  std::vector<double> numbers;
  std::istringstream words(field);
  for (std::string word; words >> word;) numbers.push_back(number_in(word, where));
  return numbers;
}

std::string text_of(const std::vector<double>& numbers) {
  std::string text;
  for (const double number : numbers) text += (text.empty() ? "" : " ") + results::csv_number(number);
  return text;
}

}  // namespace diefill::process::laboratory
