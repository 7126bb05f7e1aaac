// Names of the materials that grains and walls have unless they name others.
#pragma once

namespace diefill::engine {

inline constexpr const char *kPowderMaterial = "powder", *kWallMaterial = "walls";

}  // namespace diefill::engine
