// Broken CAD files, one named defect each, and what has to be said about them; seeds of the fuzzer as well.
#pragma once

#include <string>
#include <vector>

namespace diefill::geometry::sample {

/// A file, and the words that must stand in what is said about it: why it cannot be read, or what its mesh
/// lacks and how it was repaired.
struct BrokenFile {
  std::string defect, file, bytes;
  std::string words;
  std::string repair = "";  ///< words of the repair; empty: none may be made
};

/// Files whose bytes are broken, so that nothing can be read from them or only nonsense.
std::vector<BrokenFile> broken_bytes();

/// Files that can be read, of a surface that is broken.
std::vector<BrokenFile> broken_meshes();

}  // namespace diefill::geometry::sample
