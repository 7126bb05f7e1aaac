// Names for parts of a cavity: where the shoe arrives, in the middle, at the bottom.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "process/results/fill_result.h"

namespace diefill::process {

/// A part of the cavity and which places (m, laboratory frame) lie in it.
struct CavityPart {
  std::string words;  ///< such as "where the shoe leaves"
  std::function<bool(const Eigen::Vector3d&)> holds;
};

/// Of rings the quarter where the shoe first arrives, the one opposite and both sides; of other cavities
/// thirds along the shoe's travel. Where no shoe moves they are called by the axis.
std::vector<CavityPart> horizontal_parts(const results::FillResult& result);

/// Thirds of the height below the fill plane.
std::vector<CavityPart> vertical_parts(const results::FillResult& result);

}  // namespace diefill::process
