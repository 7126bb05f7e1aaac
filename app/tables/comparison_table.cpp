#include "app/tables/comparison_table.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "app/tables/text_column.h"
#include "process/results/rounding.h"

namespace diefill::app {

namespace {

constexpr std::size_t kWidestColumn = 48;  ///< of names; longer ones push the numbers on

std::string right(const std::string& text, std::size_t width) {
  return text.size() >= width ? text : std::string(width - text.size(), ' ') + text;
}

std::string left(const std::string& text, std::size_t width) {
  return padded(text, width);
}

constexpr int kDigitsWithoutScatter = 3;

/// Decimals of rows whose scatter is not known: those of the row that scatters most; nothing where none does.
std::optional<int> fewest_decimals(const results::ComparedMeasure& measure) {
  std::optional<int> fewest;
  for (const auto& value : measure.values)
    if (value.scatter > 0) {
      const int own = results::decimals_of_scatter(value.scatter, value.mean);
      fewest = fewest ? std::min(*fewest, own) : own;
    }
  return fewest;
}

/// A number with the decimals that `scatter` leaves to `measured`, beside which it stands.
std::string number(double value, double scatter, double measured, std::optional<int> otherwise) {
  if (!std::isfinite(value)) return "-";
  if (scatter > 0) return results::at_decimals(value, results::decimals_of_scatter(scatter, measured));
  return otherwise ? results::at_decimals(value, *otherwise)
                   : results::in_significant_digits(value, kDigitsWithoutScatter);
}

std::string difference(const results::ComparedValue& value, std::optional<int> otherwise) {
  using results::Verdict;
  if (value.verdict == Verdict::reference || value.verdict == Verdict::missing)
    return results::description(value.verdict);
  const std::string interval = number(value.interval, value.interval, value.difference, otherwise);
  if (value.verdict == Verdict::none) return "none (within +-" + interval + ')';
  std::string shown = value.difference > 0 ? "+" : "";
  shown += number(value.difference, value.interval, value.difference, otherwise);
  if (value.verdict == Verdict::scatter_unknown) return shown + " (scatter unknown)";
  return shown + " +- " + interval;
}

std::string block(const results::ComparedMeasure& measure, const std::vector<std::string>& variants,
                  std::size_t width) {
  const std::optional<int> otherwise = fewest_decimals(measure);
  std::string text = measure.name + (measure.unit == "1" ? "" : ", " + measure.unit) + '\n';
  for (std::size_t k = 0; k < variants.size(); ++k) {
    const auto& value = measure.values[k];
    text += "  " + left(variants[k], width) +
            right(number(value.mean, value.scatter, value.mean, otherwise), 12) +
            right(number(value.scatter, value.scatter, value.mean, otherwise), 11) +
            right(std::to_string(value.seeds), 7) + "  " + difference(value, otherwise) + '\n';
  }
  return text;
}

/// Runs that are not finished, and finished ones that lack values of a measure.
std::string runs_without_result(const results::Comparison& comparison) {
  std::string text;
  for (const auto& run : comparison.runs) {
    const bool finished = run.state == "finished";
    if (finished && run.reason.empty()) continue;
    text += '"' + run.variant + "\", seed " + std::to_string(run.seed) + ": " +
            (finished ? std::string("no value") : run.state) + (run.reason.empty() ? "" : ": " + run.reason) +
            '\n';
  }
  return text;
}

}  // namespace

std::string comparison_table(const results::Comparison& comparison) {
  std::size_t width = 8;
  for (const auto& variant : comparison.variants)
    width = std::max(width, std::min(kWidestColumn, character_count(variant)));
  std::string text = comparison.title + "\n  " + left("", width) + right("mean", 12) + right("scatter", 11) +
                     right("seeds", 7) + "  difference from \"" + comparison.variants.front() + "\"\n";
  for (const auto& measure : comparison.measures) text += block(measure, comparison.variants, width);
  return text + runs_without_result(comparison) + results::statistics_text() + '\n';
}

}  // namespace diefill::app
