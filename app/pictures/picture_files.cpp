#include "app/pictures/picture_files.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "render/fields/field_places.h"
#include "render/style/picture_file.h"

namespace diefill::app {
namespace {

constexpr double kLayoutWidth = 1600;

}  // namespace

std::string title_of(const PictureRequest& request, const PictureSource& source) {
  const auto& result = source.result;
  const std::string title = result.strategy.empty() ? result.title : result.strategy;
  return request.sources.size() > 1 ? source.name + ": " + title : title;
}

std::string subtitle_of(const PictureSource& source) {
  const auto& powder = source.result.powder;
  return source.result.powder_name + ", grain size " + powder.sizes_text() + ", " + source.when;
}

std::vector<const results::FillResult*> results_of(const PictureRequest& request) {
  std::vector<const results::FillResult*> results;
  for (const auto& source : request.sources) results.push_back(&source.result);
  return results;
}

std::filesystem::path file_of(const PictureRequest& request, const std::string& kind,
                              const PictureSource& source) {
  return request.out / (request.sources.size() > 1 ? kind + "_" + source.name + ".png" : kind + ".png");
}

render::ColourRange shared_range(const PictureRequest& request, const std::vector<results::Field2D>& fields) {
  std::vector<double> values;
  for (const auto& field : fields) values.insert(values.end(), field.value.begin(), field.value.end());
  const render::Interval range = render::robust_range(values);
  return {std::isnan(request.lower) ? range.lower : request.lower,
          std::isnan(request.upper) ? range.upper : request.upper};
}

double pixels_of(const PictureRequest& request) {
  // Qt draws no coarser than the layout; smaller pictures are scaled down once drawn.
  return std::max(1.0, request.width / kLayoutWidth);
}

std::filesystem::path write_picture(const PictureRequest& request, const std::filesystem::path& png,
                                    const QImage& image) {
  render::write_png(png, image, static_cast<int>(std::lround(request.width)));
  return png;
}

std::vector<std::filesystem::path> write_fields(const PictureRequest& request, const std::string& kind,
                                                const std::vector<results::Field2D>& fields,
                                                const std::vector<results::SectionPlane>& planes,
                                                render::FieldStyle style, const std::string& words) {
  const auto range = shared_range(request, fields);
  style.pixels = pixels_of(request);
  std::vector<std::filesystem::path> written;
  for (std::size_t n = 0; n < fields.size(); ++n) {
    const auto& source = request.sources[n];
    render::FieldStyle own = style;
    std::string subtitle = subtitle_of(source) + words;
    if (planes.empty()) {
      render::add_map_places(own, source.result, fields[n]);
    } else {
      render::add_section_places(own, source.result, planes[n]);
      subtitle += ", " + render::section_text(planes[n]);
    }
    const auto picture = render::compose_field(fields[n], title_of(request, source), subtitle, range, own);
    written.push_back(write_picture(request, file_of(request, kind, source), picture.image));
  }
  return written;
}

std::vector<std::filesystem::path> write_chart(const PictureRequest& request, const std::string& kind,
                                               render::Chart chart) {
  chart.pixels = pixels_of(request);
  const auto png = request.out / (kind + ".png"), pdf = request.out / (kind + ".pdf");
  render::draw_chart(png, chart);
  if (!request.pdf) return {png};
  render::draw_chart_pdf(pdf, chart);
  return {png, pdf};
}

void require_ring(const PictureRequest& request, const std::string& picture, const std::string& others) {
  for (const auto& source : request.sources)
    if (!source.result.cavity.is_ring)
      throw std::invalid_argument(picture + " needs a ring; use " + others + " for other cavities");
}

void require_powder_near_plane(const PictureRequest& request, const PictureSource& source,
                               const std::string& picture, const results::Field2D& section) {
  if (!section.first.empty()) return;
  if (request.sources.size() < 2)
    throw std::invalid_argument(picture + ": no powder near the plane; move it with --origin");
  throw std::invalid_argument(picture + ": found no powder of " + source.name +
                              " near the plane, which is the same for all results (" +
                              render::section_text(request.plane) +
                              "); move it with --origin and --normal, or draw each result alone");
}

std::string legend_of(const PictureRequest& request, const PictureSource& source) {
  return request.sources.size() > 1 ? source.name : std::string();
}

}  // namespace diefill::app
