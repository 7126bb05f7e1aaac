// How far estimates were off, measured against simulations of the same scenes.
#pragma once

#include <string>

#include "process/scene/scene.h"

namespace diefill::process::estimate {

/// An error of the mass that runs in.
struct KnownError {
  bool measured = false;
  double factor = 2;   ///< the true inflow lies between inflow / factor and inflow * factor, in nine of ten
  double packing = 0;  ///< share by which the mass of a cavity is off besides, full or not
  std::string source;  ///< the table and its command; why not measured
};

/// The error for the scene's powder, as published and nothing else of it changed. Where nothing was measured,
/// a factor of two: so far apart are the published laws of the real powder and of model grains (Bierwisch
/// 2009, Tables 4.1 and 5.2).
KnownError known_error(const Scene& scene, bool own_law);

}  // namespace diefill::process::estimate
