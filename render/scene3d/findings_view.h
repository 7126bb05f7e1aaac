// Transparent tools with a numbered mark at every finding and a legend that explains it.
#pragma once

#include <QImage>
#include <QPointF>
#include <QRectF>
#include <string>
#include <vector>

#include "render/scene3d/findings.h"

namespace diefill::render {

/// A picture and where things lie on it.
struct FindingsPicture {
  QImage image;
  std::vector<std::vector<QPointF>> marks;  ///< pixels, one a place, by finding
  std::vector<QRectF> numbers;              ///< beside the first place of each finding of the legend
  std::vector<QRectF> legend;               ///< lines of the findings that it explains
};

/// Draws all parts seen from the front, right and above. The legend explains up to twelve findings and says
/// how many more there are; those have dots without number. Throws std::runtime_error when no software
/// renderer is available.
FindingsPicture compose_findings(const std::vector<MarkedPart>& parts,
                                 const std::vector<FindingMark>& findings, const std::string& title);

}  // namespace diefill::render
