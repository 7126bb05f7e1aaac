#include "process/laboratory/published/lactose/powders_measured.h"

#include <algorithm>

#include "process/results/rounding.h"

namespace diefill::process::laboratory {
namespace {

// Ids of a calibrated set's figures, and the powder that it stands for.
constexpr struct {
  const char *ids, *powder;
} kCalibratedSets[] = {{"L100-pred-", "LH100"}, {"L220-pred-", "LH220"}};

/// As the source measured the quantity; of several runs the value that it uses.
std::string measured_by_source(const std::vector<PublishedFigure>& figures, const std::string& powder,
                               const std::string& quantity) {
  const std::string setting = "powder=" + powder;
  const auto found = std::find_if(figures.begin(), figures.end(), [&](const PublishedFigure& figure) {
    return figure.kind == "input" && figure.quantity == quantity &&
           (figure.setting == setting || figure.setting == setting + "; run=used");
  });
  return found == figures.end() ? "-" : found->published;
}

}  // namespace

std::string powders_measured(const std::vector<PublishedFigure>& figures,
                             const std::function<std::string(const PublishedFigure&)>& here) {
  std::string rows;
  for (const auto& [ids, powder] : kCalibratedSets)
    for (const auto& figure : figures)
      if (figure.id.starts_with(ids))
        rows += std::string("| ") + powder + " | " + figure.quantity + results::unit_behind(figure.unit) +
                " | " + measured_by_source(figures, powder, figure.quantity) + " | " + figure.published +
                " | " + here(figure) + " |\n";
  if (rows.empty()) return {};
  return "\n## Kottlan 2018, powders measured, predicted and here\nPredicted: by the source's regression "
         "from its calibrated set; here: that set in `diefill lab confined_compression`\nand `diefill lab "
         "shear_tester`, and whether it agrees with the prediction.\n\n"
         "| powder | quantity | measured | predicted | here |\n|---|---|---|---|---|\n" +
         rows;
}

}  // namespace diefill::process::laboratory
