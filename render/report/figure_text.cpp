#include "render/report/figure_text.h"

#include <cmath>

#include "render/report/numbers.h"

namespace diefill::render::report {
namespace {

using results::figure_called;

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  if (const std::size_t at = text.find(what); at != std::string::npos) text.replace(at, what.size(), by);
  return text;
}

}  // namespace

std::string row_title(const std::string& figure) {
  return results::title_of(figure_called(figure));
}

std::string explained(const std::string& figure) {
  return row_title(figure) + ": " + figure_called(figure).meaning;
}

std::string short_title(const std::string& figure) {
  return results::capitalised(results::short_label(figure_called(figure)));
}

std::string column_title(const std::string& figure) {
  const std::string unit = unit_in_print(figure);
  return short_title(figure) + (unit.empty() ? "" : " [" + unit + "]");
}

std::string axis_title(const std::string& figure) {
  const std::string unit = unit_in_print(figure);
  return short_title(figure) + " [" + (unit.empty() ? "–" : unit) + "]";
}

std::string unit_in_print(const std::string& figure) {
  return unit_in_print(figure_called(figure));
}

std::string unit_in_print(const results::Figure& figure) {
  const std::string unit = figure.shown.unit;
  if (unit == "1") return {};
  return unit == "deg" ? "°" : replaced(replaced(unit, "^2", "²"), "^3", "³");
}

double in_shown_unit(const std::string& figure, double value) {
  return figure_called(figure).shown.factor * value;
}

std::string shown(const std::string& figure, double value) {
  return with_unit(in_shown_unit(figure, value), unit_in_print(figure), figure_called(figure).shown.digits);
}

void add_figure(Table& table, const results::FillResult& result, const std::string& figure,
                const std::string& title) {
  const double value = results::figure_of(result, figure);
  if (std::isfinite(value))
    table.rows.push_back({title.empty() ? row_title(figure) : title, shown(figure, value)});
}

}  // namespace diefill::render::report
