#include "render/fields/arrow_map.h"

#include <cmath>

namespace diefill::render {

FieldPicture compose_arrows(const results::ArrowField& arrows, const std::string& quantity,
                            const std::string& title, const std::string& subtitle, double upper,
                            FieldStyle style) {
  style.arrows = arrows.arrows;
  style.unit = arrows.unit;
  style.scale_label = quantity;
  if (std::isnan(upper)) {
    upper = robust_range(arrows.field.value).upper;
    if (!(upper > 0)) upper = 1;
  }
  return compose_field(arrows.field, title, subtitle, {0, upper}, style);
}

}  // namespace diefill::render
