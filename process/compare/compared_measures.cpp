#include "process/compare/compared_measures.h"

#include "process/results/figure_item.h"
#include "process/results/figure_table.h"

namespace diefill::process {

const std::vector<MeasureOfComparison>& compared_measures() {
  static const std::vector<MeasureOfComparison> all = [] {
    std::vector<MeasureOfComparison> measures;
    for (const results::Figure& figure : results::figure_table())
      if (figure.compared)
        measures.push_back(
            {figure.name, figure.label, figure.shown.unit, figure.shown.factor, figure.shown.period});
    return measures;
  }();
  return all;
}

std::vector<MeasureOfComparison> measures_of_named(const std::set<std::string>& keys) {
  std::vector<MeasureOfComparison> measures;
  for (const results::Figure& figure : results::figure_table()) {
    if (!results::is_per_item(figure)) continue;
    for (const std::string& key : keys)
      if (results::find_figure(key) == &figure)
        measures.push_back({key, results::label_of(figure, results::item_of(figure, key)), figure.shown.unit,
                            figure.shown.factor, figure.shown.period});
  }
  return measures;
}

double value_of(const MeasureOfComparison& measure, const results::FillResult& result) {
  return measure.factor * results::figure_of(result, measure.key);
}

}  // namespace diefill::process
