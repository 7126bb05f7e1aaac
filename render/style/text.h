// Text on pictures: the typeface, headings that never overflow, and labels built from a field's names and
// units.
#pragma once

#include <QFont>
#include <QPainter>
#include <QString>
#include <string>

namespace diefill::render {

/// Text heights in pixels for pictures that are printed some 16 cm wide.
inline constexpr int kTitlePixels = 40;
inline constexpr int kSubtitlePixels = 29;
inline constexpr int kLabelPixels = 31;
inline constexpr int kTickPixels = 28;
inline constexpr int kNotePixels = 24;

/// DejaVu Sans of the given height in pixels (so that pictures do not depend on a screen's resolution).
QFont text_font(int pixels, bool bold = false);

/// Width of one line of text in pixels.
double text_width(const QString& text, const QFont& font);

/// A title and subtitle laid out for a given width: each wraps to at most two lines, shrinks before it
/// overflows, and is shortened with an ellipsis only when the smallest size is still too long.
class Heading {
 public:
  Heading(const std::string& title, const std::string& subtitle, double width);

  /// Height in pixels that draw() covers.
  double height() const { return title_.height + subtitle_.height; }

  /// Draws with its upper left corner at (left, top).
  void draw(QPainter& painter, double left, double top) const;

 private:
  struct Block {
    QString text;
    QFont font;
    double height = 0;
  };
  static Block fit(const std::string& text, int pixels, int least_pixels, bool bold, double width);

  double width_;
  Block title_, subtitle_;
};

/// Height in pixels of a line of text, from `pixels` down to 16, at which it is no wider than `most_width`.
int fitting_pixels(const QString& text, int pixels, double most_width);

/// Draws one line centred at `centre`, shrunk where it would be wider than `most_width`, and shortened with
/// an ellipsis where 16 pixels are still too wide. `angle` in degrees, clockwise.
void draw_centred(QPainter& painter, const QPointF& centre, const QString& text, int pixels,
                  double most_width, double angle = 0);

/// "solid fraction", "" -> "Solid fraction [–]"; "azimuth", "deg" -> "Azimuth [°]". One-letter names and
/// keys of scenes stay as they are.
QString axis_label(const std::string& name, const std::string& unit);

}  // namespace diefill::render
