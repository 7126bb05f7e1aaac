// What becomes of memory that the engine no longer needs.
#pragma once

namespace diefill::app {

/// From now on, big arrays that are freed go back to the system at once. The C library would begin to keep
/// such memory after a while, and what a search for contacts needs for a moment would be held for the whole
/// run. For commands that simulate; reading CAD, which makes and frees far more arrays, is a tenth faster
/// without. Does nothing with other C libraries than GNU's.
void give_back_freed_memory();

}  // namespace diefill::app
