#include "render/fields/place_style.h"

#include <QImage>
#include <algorithm>
#include <cmath>
#include <vector>

#include "process/results/places_without_value.h"
#include "render/style/text.h"

namespace diefill::render {
namespace {

constexpr int kSide = 28;      // of a swatch, pixels
constexpr double kApart = 34;  // between swatches

QString words(Place place) {
  switch (place) {
    case Place::kUnvalued:
      return QStringLiteral("powder, cells open: no value");
    case Place::kTool:
      return QStringLiteral("tool");
    case Place::kEmptyCavity:
      return QStringLiteral("cavity without powder");
    case Place::kAir:
      return QStringLiteral("air");
    default:
      return QStringLiteral("no powder");
  }
}

std::vector<Place> with_legend(const std::array<bool, 6>& shown) {
  std::vector<Place> places;
  for (const Place place :
       {Place::kUnvalued, Place::kEmptyCavity, Place::kTool, Place::kAir, Place::kNoPowder})
    if (shown[static_cast<std::size_t>(place)]) places.push_back(place);
  return places;
}

double entry_width(Place place) {
  return kSide + 10 + text_width(words(place), text_font(kNotePixels));
}

QRgb grey(int tone) {
  return qRgb(tone, tone, tone);
}

}  // namespace

Place place_of(double value, double first, double second, const FieldStyle& style) {
  if (!std::isnan(value)) return Place::kValue;
  if (results::is_unvalued_powder(value)) return Place::kUnvalued;
  if (results::is_inside_tool(value)) return Place::kTool;
  if (!style.in_cavity) return Place::kNoPowder;
  return style.in_cavity(first, second) ? Place::kEmptyCavity : Place::kAir;
}

QRgb place_colour(Place place, const ColourBar& bar, int column, int row) {
  const bool diverging = bar.colours == ColourScale::kDiverging;
  switch (place) {
    case Place::kUnvalued: {
      const int x = column % 12 - 3, y = row % 12 - 3;
      return x * x + y * y <= 5 ? qRgb(96, 70, 30) : qRgb(214, 186, 138);
    }
    case Place::kTool:
      return (column + row) % 18 < 3 ? grey(96) : grey(196);
    case Place::kAir:
      return grey(255);
    case Place::kEmptyCavity:
      if (!diverging) return qRgb(196, 224, 246);
      [[fallthrough]];
    default:
      return diverging && (column + row) % 14 < 3 ? grey(150) : grey(kNoValueColour.red);
  }
}

void PlacesShown::add(const PlacesShown& other) {
  for (std::size_t k = 0; k < shown_.size(); ++k) shown_[k] = shown_[k] || other.shown_[k];
}

bool PlacesShown::any() const {
  return !with_legend(shown_).empty();
}

bool PlacesShown::several() const {
  const auto places = with_legend(shown_);
  return places.size() > 1 || (places.size() == 1 && places.front() != Place::kNoPowder);
}

double PlacesShown::legend_width() const {
  double width = 0;
  for (const Place place : with_legend(shown_)) width += (width > 0 ? kApart : 0) + entry_width(place);
  return width;
}

double PlacesShown::draw_legend(QPainter& painter, const QPointF& corner, const ColourBar& bar) const {
  double left = corner.x();
  for (const Place place : with_legend(shown_)) {
    QImage look(kSide, kSide, QImage::Format_RGB32);
    for (int row = 0; row < kSide; ++row)
      for (int column = 0; column < kSide; ++column)
        look.setPixel(column, row, place_colour(place, bar, column, row));
    draw_swatch(painter, {left, corner.y()}, Qt::white, words(place));
    painter.drawImage(QRectF(left + 1, corner.y() + 1, kSide - 2, kSide - 2), look,
                      QRectF(1, 1, kSide - 2, kSide - 2));
    left += entry_width(place) + kApart;
  }
  return legend_width();
}

}  // namespace diefill::render
