#include "render/report/viewer/view_block.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <algorithm>
#include <cmath>

#include "render/scene3d/snapshot.h"
#include "render/style/colour_map.h"
#include "render/style/picture_bytes.h"

namespace diefill::render::report {
namespace {

/// The colours of all pictures, as bytes red, green, blue from low to high.
QString palette() {
  constexpr int kColours = 256;
  QByteArray bytes;
  for (int n = 0; n < kColours; ++n) {
    const Rgb colour = map_colour(static_cast<double>(n) / (kColours - 1));
    for (const auto part : {colour.red, colour.green, colour.blue}) bytes.append(static_cast<char>(part));
  }
  return QString::fromLatin1(bytes.toBase64());
}

constexpr int kStillWidth = 1000;  // pixels

/// As packed_run, within so many bytes where fewer instants can do that.
PackedRun packed_within(const ViewedRun& run, std::size_t most_bytes) {
  PackingLimits limits;
  for (;;) {
    PackedRun packed = packed_run(run, limits);
    if (static_cast<std::size_t>(packed.data.size()) <= most_bytes || limits.instants == 0) return packed;
    limits.instants = std::min(limits.instants, run.result->instants.size()) / 2;
  }
}

Figure still_of(const ViewedRun& run, const ColourRange& range) {
  ViewOptions options;
  options.lower = range.lower;
  options.upper = range.upper;
  const std::string caption = "Powder and tools at the end, cut open; grains coloured by solid fraction.";
  return {png_bytes(compose_snapshot(*run.result, options).image, kStillWidth),
          run.name.empty() ? caption : run.name + ". " + caption};
}

}  // namespace

View3D view_of(const std::vector<ViewedRun>& runs, const ColourRange& range, std::size_t most_bytes) {
  const std::size_t shown = std::min(runs.size(), kMaxViewedRuns);
  View3D view;
  QJsonArray list;
  for (std::size_t n = 0; n < shown; ++n) {
    PackedRun packed = packed_within(runs[n], most_bytes / shown);
    list.append(packed.description);
    view.data.push_back(packed.data);
    view.stills.push_back(still_of(runs[n], range));
  }
  QJsonObject description{{"runs", list}, {"palette", palette()}};
  if (std::isfinite(range.lower) && std::isfinite(range.upper))
    description["range"] = QJsonArray{range.lower, range.upper};
  if (shown < runs.size())
    view.remark = "The first " + std::to_string(shown) + " of " + std::to_string(runs.size()) + " are shown.";
  view.description = QJsonDocument(description).toJson(QJsonDocument::Compact);
  return view;
}

}  // namespace diefill::render::report
