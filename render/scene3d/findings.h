// The picture of a check's findings about tools, from plain arrays.
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <string>
#include <vector>

namespace diefill::render {

/// A surface to draw; lengths in m.
struct MarkedPart {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<Eigen::Vector3i> triangles;  ///< corners, indices into vertices
};

/// How much a finding matters: it sets the colour of its marks.
enum class MarkKind { kFault, kCare, kFact };

/// One finding with all its places.
struct FindingMark {
  MarkKind kind = MarkKind::kFact;
  std::string words;                    ///< for the legend, a line or two
  std::vector<Eigen::Vector3d> places;  ///< m
};

/// Draws the parts as glass, seen from the front, right and above, with a numbered mark at every finding and
/// a legend, as a PNG. Throws std::runtime_error when no software renderer is available or the file cannot be
/// written.
void draw_findings(const std::filesystem::path& png, const std::vector<MarkedPart>& parts,
                   const std::vector<FindingMark>& findings, const std::string& title);

}  // namespace diefill::render
