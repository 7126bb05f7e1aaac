// The exception that tells a user what is wrong with a scene.
#pragma once

#include <stdexcept>

namespace diefill::process {

/// A scene that cannot be run. The message is one line: file:line:column, key, what was found, what is
/// allowed, what to do.
struct SceneError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace diefill::process
