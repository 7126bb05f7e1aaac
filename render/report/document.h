// A report as plain content: sections of paragraphs, tables, pictures and listings. html.h and pdf.h write
// it; neither knows what a run is.
#pragma once

#include <QByteArray>
#include <string>
#include <variant>
#include <vector>

namespace diefill::render::report {

/// Running text. A remark is set off, so that it is not overlooked.
struct Paragraph {
  std::string text;
  bool remark = false;
};

/// A table; every row has as many cells as `header`. Columns after the first are numbers where `numbers` says
/// so, and then stand at the right.
struct Table {
  std::string caption;
  std::vector<std::string> header;  ///< empty: none
  std::vector<std::vector<std::string>> rows;
  bool numbers = false;
};

/// A picture as the bytes of a PNG, with what it shows.
struct Figure {
  QByteArray png;
  std::string caption;
};

/// Pictures to be seen side by side where there is room.
struct Figures {
  std::vector<Figure> figures;
  bool side_by_side = false;
};

/// Text that keeps its lines, such as a scene file.
struct Listing {
  std::string text;
};

/// A view that a reader turns, cuts and plays where the page can do that (viewer/); its still pictures stand
/// elsewhere.
struct View3D {
  QByteArray description;        ///< JSON: runs, colours, and where in `data` what lies
  std::vector<QByteArray> data;  ///< one per run, base64
  std::vector<Figure> stills;    ///< one per run
  std::string remark;            ///< what is left out; may be empty
};

/// A film as the bytes of an MP4 file.
struct Film {
  QByteArray mp4;
  std::string caption;
};

using Block = std::variant<Paragraph, Table, Figures, Listing, View3D, Film>;

/// A section; level 1 are chapters.
struct Section {
  std::string title;
  int level = 1;
  std::vector<Block> blocks;
};

/// The whole report.
struct Document {
  std::string title, subtitle;
  std::vector<Section> sections;
};

}  // namespace diefill::render::report
