#include "process/tradeoff/parameter.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "process/input/toml_string.h"

namespace diefill::process {
namespace {

std::optional<double> plain_number(const std::string& text) {
  double value = 0;
  const char* const end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, value);
  if (read.ec != std::errc() || read.ptr != end) return std::nullopt;
  return value;
}

}  // namespace

std::optional<double> number_of(const Parameter& parameter, const std::string& value) {
  if (!parameter.dimension) return plain_number(value);
  try {
    return parse_quantity(value, *parameter.dimension);
  } catch (const UnitError&) {
    return std::nullopt;
  }
}

bool same_value(const Parameter& parameter, const std::string& a, const std::string& b) {
  constexpr double kRounding = 1e-5;  // of values that were written for people
  const auto first = number_of(parameter, a), second = number_of(parameter, b);
  if (!first || !second) return a == b;
  return std::abs(*first - *second) <= kRounding * std::max(std::abs(*first), std::abs(*second));
}

int fineness(const Parameter& parameter, const std::string& a, const std::string& b) {
  if (parameter.finer == Finer::neither || same_value(parameter, a, b)) return 0;
  if (parameter.finer == Finer::as_listed) {
    const auto first = std::find(parameter.words.begin(), parameter.words.end(), a),
               second = std::find(parameter.words.begin(), parameter.words.end(), b);
    if (first == parameter.words.end() || second == parameter.words.end()) return 0;
    return first < second ? -1 : 1;
  }
  const auto first = number_of(parameter, a), second = number_of(parameter, b);
  if (!first || !second) return 0;
  return (*first < *second) == (parameter.finer == Finer::smaller) ? 1 : -1;
}

std::string in_millimetres(double metres) {
  return number_text(1e3 * metres) + " mm";
}

std::string toml_value(const std::string& value) {
  const bool bare = value == "true" || value == "false" || plain_number(value).has_value() ||
                    value.starts_with('[') || value.starts_with('{') || value.starts_with('"');
  return bare ? value : toml_string(value);
}

std::function<SceneChanges(const Scene&, const std::string&)> sets_key(const std::string& key) {
  return [key](const Scene&, const std::string& value) {
    return SceneChanges{key + " = " + toml_value(value) + '\n', {}};
  };
}

}  // namespace diefill::process
