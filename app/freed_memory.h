// Returns memory to the system that the engine no longer needs.
#pragma once

namespace diefill::app {

/// From now on, large arrays that are freed go back to the system at once. The C library would start to keep
/// such memory after a while, and what a contact search needs for a moment would be held for the whole run.
/// For commands that simulate; reading CAD, which allocates far more arrays, is a tenth faster without. Does
/// nothing with C libraries other than GNU's.
void give_back_freed_memory();

}  // namespace diefill::app
