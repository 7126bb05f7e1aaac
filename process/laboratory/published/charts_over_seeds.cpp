#include "process/laboratory/published/charts_over_seeds.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "process/results/studies/mean.h"

namespace diefill::process::laboratory {
namespace {

using results::ExperimentChart;
using results::ExperimentSeries;

/// What a series over all seeds shows.
struct Shown {
  bool points = false, mean = false, first = false;
};

bool has_value(const ExperimentSeries& series) {
  return std::any_of(series.y.begin(), series.y.end(), [](double value) { return std::isfinite(value); });
}

bool is_measured(const ExperimentSeries& series) {
  return series.role != ExperimentSeries::Role::published;
}

bool are_the_same(const std::vector<ExperimentSeries>& seeds) {
  return std::all_of(seeds.begin(), seeds.end(), [&](const ExperimentSeries& one) {
    return one.x == seeds.front().x && one.y == seeds.front().y;
  });
}

const ExperimentSeries& longest_of(const std::vector<ExperimentSeries>& seeds) {
  return *std::max_element(seeds.begin(), seeds.end(),
                           [](const auto& one, const auto& other) { return one.x.size() < other.x.size(); });
}

/// Whether each place of a curve is there once, and those of the others are among those of the longest.
bool have_common_places(const std::vector<ExperimentSeries>& seeds, const ExperimentSeries& longest) {
  auto places = longest.x;
  std::sort(places.begin(), places.end());
  if (std::adjacent_find(places.begin(), places.end()) != places.end()) return false;
  return std::all_of(seeds.begin(), seeds.end(), [&](const ExperimentSeries& one) {
    return std::all_of(one.x.begin(), one.x.end(),
                       [&](double x) { return std::binary_search(places.begin(), places.end(), x); });
  });
}

/// Mean and standard deviation over the seeds at each place of `longest`; no deviation of fewer than two.
ExperimentSeries mean_series(const std::vector<ExperimentSeries>& seeds, const ExperimentSeries& longest) {
  ExperimentSeries mean = longest;
  mean.y_scatter.assign(mean.x.size(), 0);
  for (std::size_t k = 0; k < mean.x.size(); ++k) {
    std::vector<double> values;
    for (const ExperimentSeries& one : seeds) {
      const auto at = std::find(one.x.begin(), one.x.end(), mean.x[k]);
      if (at != one.x.end()) values.push_back(one.y[static_cast<std::size_t>(at - one.x.begin())]);
    }
    std::erase_if(values, [](double value) { return !std::isfinite(value); });
    mean.y[k] = results::mean_of(values);
    double squares = 0;
    for (const double value : values) squares += (value - mean.y[k]) * (value - mean.y[k]);
    if (values.size() > 1) mean.y_scatter[k] = std::sqrt(squares / static_cast<double>(values.size() - 1));
  }
  return mean;
}

ExperimentSeries series_over_seeds(const std::vector<ExperimentSeries>& seeds, Shown& shown) {
  ExperimentSeries one = seeds.front();
  if (seeds.size() == 1 || !is_measured(one) || are_the_same(seeds)) return one;
  if (one.role == ExperimentSeries::Role::points) {
    shown.points = true;
    for (std::size_t k = 1; k < seeds.size(); ++k) {
      one.x.insert(one.x.end(), seeds[k].x.begin(), seeds[k].x.end());
      one.y.insert(one.y.end(), seeds[k].y.begin(), seeds[k].y.end());
    }
    return one;
  }
  const ExperimentSeries& longest = longest_of(seeds);
  const bool common = have_common_places(seeds, longest);
  (common ? shown.mean : shown.first) = true;
  return common ? mean_series(seeds, longest) : one;
}

std::string words_for(std::size_t seeds, const Shown& shown) {
  if (seeds < 2) return "one seed";
  const std::string number = std::to_string(seeds) + " seeds";
  std::string words;
  if (shown.mean) words = "mean and standard deviation over " + number;
  if (shown.points) words += (words.empty() ? "" : ", ") + std::string("points of ") + number;
  if (shown.first) words += words.empty() ? "curves of the first of " + number : ", other curves: first seed";
  return words.empty() ? number : words;
}

/// The series of all seeds by name; of those with the same name in a chart, by which of them it is.
std::vector<std::vector<ExperimentSeries>> series_by_name(const std::vector<ExperimentChart>& charts) {
  std::vector<std::vector<ExperimentSeries>> groups;
  std::map<std::pair<std::string, int>, std::size_t> group_of;
  for (const ExperimentChart& chart : charts) {
    std::map<std::string, int> before;
    for (const ExperimentSeries& series : chart.series) {
      const auto [found, is_new] =
          group_of.emplace(std::pair(series.name, before[series.name]++), groups.size());
      if (is_new) groups.emplace_back();
      groups[found->second].push_back(series);
    }
  }
  return groups;
}

/// `charts` has the same chart of each seed that has it.
ExperimentChart chart_over_seeds(const std::vector<ExperimentChart>& charts) {
  ExperimentChart all = charts.front();
  if (all.first_seed_only) {
    all.subtitle += std::string(all.subtitle.empty() ? "" : "; ") +
                    (charts.size() > 1 ? "first of " + std::to_string(charts.size()) + " seeds" : "one seed");
    return all;
  }
  all.series.clear();
  Shown shown;
  for (const auto& seeds : series_by_name(charts)) all.series.push_back(series_over_seeds(seeds, shown));
  const auto count = std::count_if(charts.begin(), charts.end(), [](const ExperimentChart& chart) {
    return std::any_of(chart.series.begin(), chart.series.end(), is_measured);
  });
  if (count > 0)
    all.subtitle += (all.subtitle.empty() ? "" : "; ") + words_for(static_cast<std::size_t>(count), shown);
  const auto has_note = [&](const ExperimentChart& chart) { return chart.note == all.note; };
  if (!std::all_of(charts.begin(), charts.end(), has_note)) all.note = "First seed: " + all.note;
  return all;
}

}  // namespace

std::vector<ExperimentChart> charts_over_seeds(std::vector<std::vector<ExperimentChart>> of_seeds) {
  std::vector<std::vector<ExperimentChart>> by_name;
  for (auto& charts : of_seeds)
    for (ExperimentChart& chart : charts) {
      std::erase_if(chart.series, [](const ExperimentSeries& series) { return !has_value(series); });
      const auto same = std::find_if(by_name.begin(), by_name.end(),
                                     [&](const auto& group) { return group.front().name == chart.name; });
      if (same == by_name.end())
        by_name.push_back({std::move(chart)});
      else
        same->push_back(std::move(chart));
    }
  std::vector<ExperimentChart> all;
  for (const auto& group : by_name) all.push_back(chart_over_seeds(group));
  return all;
}

}  // namespace diefill::process::laboratory
