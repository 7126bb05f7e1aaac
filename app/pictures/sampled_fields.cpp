#include "app/pictures/sampled_fields.h"

#include "process/measure/fields/ring_sample.h"

namespace diefill::app {

SampledFields sampled_maps(const PictureRequest& request, const ValueOfResult& value_of) {
  SampledFields sampled;
  for (const auto& source : request.sources) {
    const auto& result = source.result;
    sampled.fields.push_back(process::sample_ring(result.powder, result.tools, result.cavity,
                                                  request.averaging_width, value_of(result)));
  }
  return sampled;
}

SampledFields sampled_sections(const PictureRequest& request, const std::string& picture,
                               const ValueOfResult& value_of) {
  SampledFields sampled;
  for (const auto& source : request.sources) {
    const auto& result = source.result;
    sampled.fields.push_back(process::sample_plane(result.powder, result.solid_fraction, result.tools,
                                                   request.plane, request.averaging_width, value_of(result))
                                 .field);
    require_powder_near_plane(request, source, picture, sampled.fields.back());
    sampled.planes.push_back(request.plane);
  }
  return sampled;
}

}  // namespace diefill::app
