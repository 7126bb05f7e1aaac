// STEP files of assemblies for tests: products made of blocks, placed in products, as CAD programs nest them.
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace diefill::step_files {

/// Corners of an upright block, mm.
struct Block {
  std::array<double, 3> lower, upper;
};

/// One block less others.
struct StepPart {
  std::string name;
  Block block;
  std::vector<Block> cut;
};

/// Where a product stands in its assembly: turned about the z axis first, then moved.
struct StepPlace {
  double quarter_turns = 0;
  std::array<double, 3> move = {0, 0, 0};  ///< mm
};

/// A part or another assembly in an assembly.
struct StepUse {
  std::string product;
  StepPlace place;
};

struct StepAssembly {
  std::string name;
  std::vector<StepUse> uses;  ///< of products named before
};

/// Writes the assemblies, each after those it uses; the last holds all. Throws std::runtime_error on failure.
void write_step(const std::filesystem::path& file, const std::vector<StepPart>& parts,
                const std::vector<StepAssembly>& assemblies);

}  // namespace diefill::step_files
