// The tools as drawn through glass, with a numbered mark at every finding and a legend that says what it is.
#pragma once

#include <Eigen/Core>
#include <QImage>
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

/// A picture and where things lie on it.
struct FindingsPicture {
  QImage image;
  std::vector<std::vector<QPointF>> marks;  ///< pixels, one a place, by finding
};

/// Draws all parts seen from the front, right and above. Findings beyond the twelfth have marks without lines
/// in the legend. Throws std::runtime_error when no software renderer is available.
FindingsPicture compose_findings(const std::vector<MarkedPart>& parts,
                                 const std::vector<FindingMark>& findings, const std::string& title);

/// The same as a PNG.
void draw_findings(const std::filesystem::path& png, const std::vector<MarkedPart>& parts,
                   const std::vector<FindingMark>& findings, const std::string& title);

}  // namespace diefill::render
