// Returns memory that the engine no longer needs to the system.
#pragma once

namespace diefill::app {

/// From now on, arrays of some 10^5 grains and more that are freed go back to the system at once. The C
/// library would start to keep such memory after a while, and what a contact search needs for a moment would
/// be held for the whole run. Smaller ones are kept: memory that every search asks for again costs a page
/// fault for each 4 KiB, which the threads of a run wait for (engine/PERFORMANCE.md). For commands that
/// simulate; reading CAD, which allocates far more arrays, is a tenth faster without. Does nothing with C
/// libraries other than GNU's.
void release_freed_memory();

}  // namespace diefill::app
