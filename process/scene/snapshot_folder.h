// Folders that snapshots of a run are kept in.
#pragma once

#include <string>

#include "process/scene/scene.h"

namespace diefill::process {

/// Name of the snapshot's folder: its name with `_` for all but a-z, A-Z, 0-9, `-` and `_`; a name with other
/// letters than ASCII also gets a number that is derived from it, or all such names of one length would be
/// one.
std::string snapshot_folder(const std::string& name);

/// Whether any snapshot of the one would be kept in a folder of the other.
bool have_same_folder(const SnapshotSpec& one, const SnapshotSpec& other);

}  // namespace diefill::process
