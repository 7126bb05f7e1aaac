// How far estimates were off, measured against simulations of the same scenes.
#pragma once

#include <string>

namespace diefill::process::estimate {

/// An error of the mass that runs in.
struct KnownError {
  bool measured = false;
  double factor = 2;   ///< the true mass lies between mass / factor and mass * factor, in nine cases of ten
  std::string source;  ///< the table and its command; why not measured
};

/// The error for a powder of this preset's name. Where nothing was measured, a factor of two: so far apart
/// are the published laws of the real powder and of model grains (Bierwisch 2009, Tables 4.1 and 5.2).
KnownError known_error(const std::string& powder, bool own_law);

}  // namespace diefill::process::estimate
