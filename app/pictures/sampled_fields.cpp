#include "app/pictures/sampled_fields.h"

#include <stdexcept>

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
    const auto plane = request.plane_given ? request.plane : result.sections.front().plane;
    sampled.fields.push_back(process::sample_plane(result.powder, result.solid_fraction, result.tools, plane,
                                                   request.averaging_width, value_of(result))
                                 .field);
    if (sampled.fields.back().first.empty())
      throw std::invalid_argument(picture + ": no powder near the plane; move it with --origin");
    sampled.planes.push_back(plane);
  }
  return sampled;
}

}  // namespace diefill::app
