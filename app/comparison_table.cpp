#include "app/comparison_table.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "app/text_column.h"

namespace diefill::app {

namespace {

constexpr std::size_t kWidestColumn = 48;  ///< of names; longer ones push the numbers on

std::string right(const std::string& text, std::size_t width) {
  return text.size() >= width ? text : std::string(width - text.size(), ' ') + text;
}

std::string left(const std::string& text, std::size_t width) {
  return padded(text, width);
}

/// Decimals that show the scatter with two digits, or the value with four where the scatter is not known.
int decimals_for(const results::ComparedMeasure& measure) {
  double least = 0, largest = 0;
  for (const auto& value : measure.values) {
    if (value.scatter > 0) least = least > 0 ? std::min(least, value.scatter) : value.scatter;
    if (std::isfinite(value.mean)) largest = std::max(largest, std::abs(value.mean));
  }
  const double shown = least > 0 ? least / 10 : largest / 1000;
  return shown > 0 ? std::clamp(static_cast<int>(std::ceil(-std::log10(shown))), 0, 6) : 2;
}

std::string number(double value, int decimals, bool with_sign = false) {
  if (!std::isfinite(value)) return "-";
  char text[48];
  std::snprintf(text, sizeof text, with_sign ? "%+.*f" : "%.*f", decimals, value);
  return text;
}

std::string difference(const results::ComparedValue& value, int decimals) {
  using results::Verdict;
  if (value.verdict == Verdict::reference || value.verdict == Verdict::missing)
    return results::in_words(value.verdict);
  if (value.verdict == Verdict::none) return "none (within +-" + number(value.interval, decimals) + ')';
  const std::string shown = number(value.difference, decimals, true);
  if (value.verdict == Verdict::scatter_unknown) return shown + " (scatter unknown)";
  return shown + " +- " + number(value.interval, decimals);
}

std::string block(const results::ComparedMeasure& measure, const std::vector<std::string>& variants,
                  std::size_t width) {
  const int decimals = decimals_for(measure);
  std::string text = measure.name + (measure.unit == "1" ? "" : ", " + measure.unit) + '\n';
  for (std::size_t k = 0; k < variants.size(); ++k) {
    const auto& value = measure.values[k];
    text += "  " + left(variants[k], width) + right(number(value.mean, decimals), 12) +
            right(number(value.scatter, decimals), 11) + right(std::to_string(value.seeds), 7) + "  " +
            difference(value, decimals) + '\n';
  }
  return text;
}

std::string runs_without_result(const results::Comparison& comparison) {
  std::string text;
  for (const auto& run : comparison.runs) {
    if (run.state == "finished") continue;
    text += '"' + run.variant + "\", seed " + std::to_string(run.seed) + ": " + run.state +
            (run.reason.empty() ? "" : ": " + run.reason) + '\n';
  }
  return text;
}

}  // namespace

std::string comparison_table(const results::Comparison& comparison) {
  std::size_t width = 8;
  for (const auto& variant : comparison.variants)
    width = std::max(width, std::min(kWidestColumn, letters_in(variant)));
  std::string text = comparison.title + "\n  " + left("", width) + right("mean", 12) + right("scatter", 11) +
                     right("seeds", 7) + "  difference from \"" + comparison.variants.front() + "\"\n";
  for (const auto& measure : comparison.measures) text += block(measure, comparison.variants, width);
  return text + runs_without_result(comparison) + results::statistics_in_words() + '\n';
}

}  // namespace diefill::app
