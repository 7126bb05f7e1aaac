// Reads CAD files in a child process: a crash of a library on a broken file does not end this process, and
// the child does not outlive it.
#pragma once

#include <functional>
#include <stdexcept>
#include <string>

#include "geometry/cad/cad_parts.h"

namespace diefill::geometry {

/// Limits of a child.
struct ChildLimits {
  std::size_t file_bytes = 0;  ///< size of the file to be read
  unsigned seconds = 60;       ///< of processor time for a small file
};

/// Why a child has read nothing.
enum class ChildFailure : char {
  kRefused,        ///< the reader says why
  kCrashed,        ///< the file made a library crash
  kTooLong,        ///< processor or wall time is used up
  kTooMuchMemory,  ///< it asked for more than it may take
  kNoChild         ///< there was no pipe or no process to read in
};

/// The failure, and what to tell of it.
struct ChildError : std::runtime_error {
  ChildError(ChildFailure why, const std::string& text) : std::runtime_error(text), failure(why) {}
  ChildFailure failure;
};

/// Calls `read` in a child process and returns its result. The child may take 2 GiB of memory and the given
/// processor time, and more for large files: 24 bytes and 10 microseconds per byte of the file; three times
/// that in wall time, for readers that wait. Throws ChildError, also when the child crashed or was killed.
/// Call from a thread while no other one is reading a file.
CadParts read_in_child(const std::function<CadParts()>& read, const ChildLimits& limits);

}  // namespace diefill::geometry
