// A value sampled around the ring, or in a plane, of every source of a picture.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/pictures/picture_files.h"
#include "process/measure/fields/plane_sample.h"

namespace diefill::app {

/// The value of a result at its points, as it is prepared once for all of them.
using ValueOfResult = std::function<process::PlaneValue(const results::FillResult&)>;

/// One field a source; `planes`: of sections, empty for maps.
struct SampledFields {
  std::vector<results::Field2D> fields;
  std::vector<results::SectionPlane> planes;
};

/// Over azimuth and height. Throws std::invalid_argument for cavities that are no rings.
SampledFields sampled_maps(const PictureRequest& request, const ValueOfResult& value_of);

/// In the request's plane. Throws std::invalid_argument, with the
/// name of the `picture`, where no powder is near.
SampledFields sampled_sections(const PictureRequest& request, const std::string& picture,
                               const ValueOfResult& value_of);

}  // namespace diefill::app
