// Results of pilot runs, cached per machine, so that a second plan of a scene is quick.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "process/plan/pilot.h"

namespace diefill::process::plan {

struct PlanOptions;  // plan.h

/// The user's cache folder: $XDG_CACHE_HOME/diefill/pilots, or
/// ~/.cache/diefill/pilots; empty where neither is known.
std::filesystem::path pilot_cache_folder();

/// Name under which a pilot is kept: the same for scenes that ask for the same computation with the same
/// tools and limit, on as many threads, by the same build of the program on the same machine.
std::string pilot_name(const Scene& scene, const Tooling& tooling, int threads, double wall_limit);

/// The pilot of that name in `folder`; nothing where there is none that can be read.
std::optional<Pilot> cached_pilot(const std::filesystem::path& folder, const std::string& name);

/// Keeps the pilot, and at most kMaxPilots of the newest; a folder that cannot be written to keeps none.
void store_pilot(const std::filesystem::path& folder, const std::string& name, const Pilot& pilot);
inline constexpr std::size_t kMaxPilots = 200;

/// The pilot that was kept of this scene, or a new one, which is kept. `tooling` is that of the scene.
Pilot pilot_for(const Scene& scene, const Tooling& tooling, const PlanOptions& options);

}  // namespace diefill::process::plan
