#include "app/options/numbers.h"

#include <charconv>
#include <cmath>
#include <limits>
#include <optional>

#include "process/input/units.h"

namespace diefill::app {
namespace {

/// The whole text as a number; nothing for anything else.
template <class Number>
std::optional<Number> number_in(const std::string& text) {
  const char* first = text.data();
  const char* const last = first + text.size();
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') ++first;
  Number value{};
  const auto read = std::from_chars(first, last, value);
  if (read.ec != std::errc() || read.ptr != last) return std::nullopt;
  return value;
}

CLI::Validator finite(const std::string& allowed, const std::string& help, auto within) {
  return CLI::Validator(
      [allowed, within](std::string& text) {
        const auto value = number_in<double>(text);
        if (value && std::isfinite(*value) && within(*value)) return std::string();
        return "found \"" + text + "\", allowed: " + allowed;
      },
      help);
}

}  // namespace

CLI::Validator whole_number(long long least, long long most) {
  const std::string from = std::to_string(least), to = std::to_string(most);
  return CLI::Validator(
      [=](std::string& text) {
        const auto value = number_in<long long>(text);
        const bool octal = text.size() > 1 && text.find_first_not_of("+-") == text.find('0');  // to CLI11
        if (value && !octal && *value >= least && *value <= most) return std::string();
        return "found \"" + text + "\", allowed: a whole number from " + from + " to " + to;
      },
      "INT in [" + from + " - " + to + "]");
}

CLI::Validator number_within(double least, double most) {
  const std::string from = process::number_text(least), to = process::number_text(most);
  return finite("a number from " + from + " to " + to, "FLOAT in [" + from + " - " + to + "]",
                [=](double value) { return value >= least && value <= most; });
}

CLI::Validator number_above_zero() {
  return finite("a finite number above 0", "POSITIVE", [](double value) { return value > 0; });
}

}  // namespace diefill::app
