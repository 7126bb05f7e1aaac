// The density of a mesh as files that a press simulation reads.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "process/measure/fields/element_density.h"

namespace diefill::process {

/// What the head of the files states.
struct DensityNote {
  std::string mesh;   ///< name of the user's mesh file
  std::string title;  ///< of the run
};

/// Writes into `folder`, each file whole or not at all: STEM_density_elements.csv, STEM_density_nodes.csv (SI
/// units), STEM_density_abaqus.inp (*INITIAL CONDITIONS, TYPE=RELATIVE DENSITY) and STEM_density_calculix.inp
/// (the same as TYPE=TEMPERATURE, which CalculiX has), both over nodes, and STEM_density_outside.csv, the
/// elements outside the powder; and, where there are some, STEM_density_above_solid.csv, those denser than
/// their solid. Nodes outside get no card. Returns the files. Throws results::ResultError where they cannot
/// be written.
std::vector<std::filesystem::path> write_density_files(const std::filesystem::path& folder,
                                                       const std::string& stem,
                                                       const results::SolidMesh& mesh,
                                                       const ElementDensity& density,
                                                       const DensityNote& note);

/// The name of a file without folders and ending, for the names of others: letters, digits, - and _ stay.
std::string file_stem(const std::filesystem::path& file);

}  // namespace diefill::process
