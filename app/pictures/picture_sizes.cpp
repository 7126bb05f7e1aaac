// Pictures of where large and small grains lie.
#include <memory>

#include "app/pictures/picture_files.h"
#include "app/pictures/sampled_fields.h"
#include "process/measure/figures/segregation.h"

namespace diefill::app {
namespace {

/// mm.
ValueOfResult size_with(double averaging_width) {
  return [averaging_width](const results::FillResult& result) -> process::PlaneValue {
    const auto size = std::make_shared<const process::SizeField>(result.powder, averaging_width);
    return [size](const Eigen::Vector3d& point) { return size->at(point); };
  };
}

/// All sources on one scale.
Pictures draw_sizes(const PictureRequest& request, const std::string& name, SampledFields sampled) {
  for (auto& field : sampled.fields) field.quantity = std::string("mean grain diameter");
  render::FieldStyle style;
  style.unit = "mm";
  style.note = "weighted by mass";
  return write_fields(request, name, sampled.fields, sampled.planes, style);
}

}  // namespace

Pictures make_size_map(const PictureRequest& request) {
  require_ring(request, "size-map", "size-section");
  return draw_sizes(request, "size_map", sampled_maps(request, size_with(request.averaging_width)));
}

Pictures make_size_section(const PictureRequest& request) {
  return draw_sizes(request, "size_section",
                    sampled_sections(request, "size-section", size_with(request.averaging_width)));
}

}  // namespace diefill::app
