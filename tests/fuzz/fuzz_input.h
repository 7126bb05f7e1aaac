// What the fuzzers feed to the importers, and what comes of it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace diefill::geometry::fuzz {

/// A CAD file to be: the ending of its name, and its bytes.
struct FuzzInput {
  std::string ending, bytes;
};

/// One file of each kind, the STEP and IGES files of the sample tools, and the broken files of the tests.
std::vector<FuzzInput> seeds();

/// The input as one string of bytes, of which the first says what kind of file the rest is.
std::string packed(const FuzzInput& input);
FuzzInput unpacked(const std::string& bytes);

/// Imports, checks and repairs `file`, and says in a few words that do not name it how that ended. Lets
/// everything pass but the MeshError that a bad file has to end in.
std::string outcome_of(const std::filesystem::path& file);

}  // namespace diefill::geometry::fuzz
