#include "process/measure/figures/figures.h"

namespace diefill::process {

const std::vector<FigureMeasure>& figure_measures() {
  static const std::vector<FigureMeasure> all = {
      top_to_bottom, azimuthal_harmonics, travel_harmonics,   field_evenness,
      fill_height,   size_segregation,    powder_segregation,
  };
  return all;
}

void measure_figures(results::FillResult& result) {
  if (!(result.cavity.volume > 0)) return;
  for (const FigureMeasure& measure : figure_measures()) measure(result, result.figures);
}

}  // namespace diefill::process
