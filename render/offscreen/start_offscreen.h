// Sets up Qt and the renderer for pictures without a screen.
#pragma once

namespace diefill::render {

/// Sets up drawing without a screen. Call once, before any picture; `argc` and `argv` go to Qt.
/// Throws std::runtime_error when no software renderer is available.
void start_offscreen(int& argc, char** argv);

}  // namespace diefill::render
