// What the makers of pictures share: titles, file names, writing at the requested width.
#pragma once

#include "app/pictures/picture_kinds.h"
#include "render/charts/chart.h"
#include "render/fields/density_map.h"

class QImage;

namespace diefill::app {

/// "Strategy" of the source; with several sources its directory's name before it.
std::string title_of(const PictureRequest& request, const PictureSource& source);

/// Powder, grain size, time, and the directory's name as source.
std::string subtitle_of(const PictureSource& source);

std::vector<const results::FillResult*> results_of(const PictureRequest& request);

/// DIR's file for a kind: kind.png, or kind_<name>.png where there are several sources.
std::filesystem::path file_of(const PictureRequest& request, const std::string& kind,
                              const PictureSource& source);

/// One scale for the fields of all sources, unless the user has given one.
render::ColourRange shared_range(const PictureRequest& request, const std::vector<results::Field2D>& fields);

/// Layout points to pixels for the requested width.
double pixels_of(const PictureRequest& request);

/// Writes the picture scaled to exactly the requested width; returns its path.
std::filesystem::path write_picture(const PictureRequest& request, const std::filesystem::path& png,
                                    const QImage& image);

/// Draws one field a source as kind.png, all on one scale and in one style. `planes` has the plane of each
/// where they are sections, and is empty where they are maps; `words` stand after the subtitle.
std::vector<std::filesystem::path> write_fields(const PictureRequest& request, const std::string& kind,
                                                const std::vector<results::Field2D>& fields,
                                                const std::vector<results::SectionPlane>& planes,
                                                render::FieldStyle style, const std::string& words = "");

/// Writes a chart of all sources as kind.png, and kind.pdf where that is requested.
std::vector<std::filesystem::path> write_chart(const PictureRequest& request, const std::string& kind,
                                               render::Chart chart);

/// Throws std::invalid_argument where a source's cavity is no ring; `others` are the kinds of picture to use
/// then.
void require_ring(const PictureRequest& request, const std::string& picture, const std::string& others);

/// Throws std::invalid_argument where the source's section in the request's plane is empty.
void require_powder_near_plane(const PictureRequest& request, const PictureSource& source,
                               const std::string& picture, const results::Field2D& section);

/// Legend name of a source: none where it is alone.
std::string legend_of(const PictureRequest& request, const PictureSource& source);

}  // namespace diefill::app
