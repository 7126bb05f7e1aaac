#include "render/fields/difference_map.h"

namespace diefill::render {

FieldPicture compose_difference(const results::Field2D& change, const std::string& title,
                                const std::string& compared, double limit, FieldStyle style) {
  style.diverging = true;
  style.mark_mean = true;
  return compose_field(change, title, compared, {-limit, limit}, style);
}

}  // namespace diefill::render
