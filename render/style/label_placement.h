// Places for labels of points so that none covers another, a point, or the frame.
#pragma once

#include <QLineF>
#include <QRectF>
#include <vector>

namespace diefill::render {

/// A point to be labelled and the room its label takes.
struct LabelledPoint {
  QPointF at;
  QSizeF label;
  double radius = 10;  ///< of the point's own mark
};

/// The shortest line from the edge of a point's mark to its label; of no length where they touch.
QLineF leader_of(const QRectF& label, const LabelledPoint& point);

/// A rectangle for each label, in order, inside `area`: as near its point as goes, clear of all other labels
/// and their leaders, of all marks and of `taken`. Where there is no such place, the one that covers least.
/// The same points give the same places.
std::vector<QRectF> place_labels(const std::vector<LabelledPoint>& points, const QRectF& area,
                                 const std::vector<QRectF>& taken = {});

}  // namespace diefill::render
