#include "render/fields/arrow_map.h"

#include <cmath>

#include "render/fields/arrow_painter.h"

namespace diefill::render {

ArrowScale common_scale(const std::vector<results::ArrowField>& all) {
  std::vector<double> values;
  FieldStyle arrows;
  for (const auto& one : all) {
    values.insert(values.end(), one.field.value.begin(), one.field.value.end());
    arrows.arrows.insert(arrows.arrows.end(), one.arrows.begin(), one.arrows.end());
  }
  const double upper = robust_range(values).upper;
  return {upper > 0 ? upper : 1, legend_arrow(arrows)};
}

FieldPicture compose_arrows(const results::ArrowField& arrows, const std::string& quantity,
                            const std::string& title, const std::string& subtitle, double upper,
                            FieldStyle style) {
  style.arrows = arrows.arrows;
  style.unit = arrows.unit;
  style.scale_label = quantity;
  if (std::isnan(upper)) upper = common_scale({arrows}).upper;
  return compose_field(arrows.field, title, subtitle, {0, upper}, style);
}

}  // namespace diefill::render
