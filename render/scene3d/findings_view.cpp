#include "render/scene3d/findings_view.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkFeatureEdges.h>
#include <vtkLightKit.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkUnsignedCharArray.h>

#include <Eigen/Geometry>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "render/offscreen/offscreen.h"
#include "render/scene3d/mesh_polydata.h"
#include "render/style/label_placement.h"
#include "render/style/picture_file.h"
#include "render/style/text.h"

namespace diefill::render {
namespace {

constexpr int kWidth = 1600, kHeight = 1100, kLegendWidth = 500, kMargin = 36, kOversampling = 2;
constexpr std::size_t kMaxLines = 12;
constexpr double kMetresToMillimetres = 1e3;  // single precision in the renderer likes numbers near one
constexpr double kSharpEdge = 25;             // degrees

/// Orthogonal directions of the view: to the right of the picture, up, and towards the eye.
struct View {
  Eigen::Vector3d right, up, eye, centre;
  double height = 1;  ///< m, that the picture shows
};

View view_of(const std::vector<MarkedPart>& parts, double aspect) {
  View view;
  view.eye = Eigen::Vector3d(0.55, -0.85, 0.6).normalized();
  view.right = Eigen::Vector3d::UnitZ().cross(view.eye).normalized();
  view.up = view.eye.cross(view.right);
  Eigen::Vector3d lower = Eigen::Vector3d::Constant(1e300);
  Eigen::Vector3d upper = -lower;
  for (const auto& part : parts)
    for (const auto& v : part.vertices) {
      const Eigen::Vector3d seen(v.dot(view.right), v.dot(view.up), v.dot(view.eye));
      lower = lower.cwiseMin(seen);
      upper = upper.cwiseMax(seen);
    }
  const Eigen::Vector3d middle = (lower + upper) / 2;
  const Eigen::Vector3d size = upper - lower;
  view.centre = middle[0] * view.right + middle[1] * view.up + middle[2] * view.eye;
  view.height = 1.1 * std::max(size[1], size[0] / aspect);
  return view;
}

void add_glass(vtkRenderer* renderer, vtkPolyData* mesh) {
  const auto mapper = vtkSmartPointer<vtkPolyDataMapper>::New();
  mapper->SetInputData(mesh);
  const auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0.55, 0.65, 0.78);
  actor->GetProperty()->SetOpacity(0.13);
  actor->GetProperty()->SetInterpolationToFlat();
  renderer->AddActor(actor);
}

/// Edges of the shape and of holes, not those between the facets of a round wall.
void add_edges(vtkRenderer* renderer, vtkPolyData* mesh) {
  const auto edges = vtkSmartPointer<vtkFeatureEdges>::New();
  edges->SetInputData(mesh);
  edges->SetFeatureAngle(kSharpEdge);
  edges->ColoringOff();
  edges->Update();
  const auto mapper = vtkSmartPointer<vtkPolyDataMapper>::New();
  mapper->SetInputData(edges->GetOutput());
  mapper->ScalarVisibilityOff();
  const auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0.25, 0.28, 0.33);
  actor->GetProperty()->SetLineWidth(1.5F * kOversampling);
  actor->GetProperty()->LightingOff();
  renderer->AddActor(actor);
}

QImage draw_parts(const std::vector<MarkedPart>& parts, const View& view, const QSize& size) {
  const auto window = vtkSmartPointer<OffscreenWindow>::New();
  const int width = kOversampling * size.width(), height = kOversampling * size.height();
  window->open(width, height);
  const auto renderer = vtkSmartPointer<vtkRenderer>::New();
  renderer->SetBackground(1, 1, 1);
  window->AddRenderer(renderer);
  for (const auto& part : parts) {
    if (part.triangles.empty()) continue;
    const auto mesh = mesh_polydata(part.vertices, part.triangles);
    add_glass(renderer, mesh);
    add_edges(renderer, mesh);
  }
  renderer->AutomaticLightCreationOff();
  const auto lights = vtkSmartPointer<vtkLightKit>::New();
  lights->AddLightsToRenderer(renderer);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  const Eigen::Vector3d target = kMetresToMillimetres * view.centre;
  const Eigen::Vector3d eye = target + 20 * kMetresToMillimetres * view.height * view.eye;
  camera->SetFocalPoint(target.data());
  camera->SetPosition(eye.data());
  camera->SetViewUp(view.up.data());
  camera->SetParallelScale(0.5 * kMetresToMillimetres * view.height);
  renderer->ResetCameraClippingRange();
  window->Render();
  const auto pixels = vtkSmartPointer<vtkUnsignedCharArray>::New();
  window->GetPixelData(0, 0, width - 1, height - 1, 0, pixels, 0);
  return QImage(pixels->GetPointer(0), width, height, 3 * width, QImage::Format_RGB888)
      .mirrored()
      .scaled(size, Qt::IgnoreAspectRatio, Qt::SmoothTransformation)
      .convertToFormat(QImage::Format_RGB32);
}

QPointF place_on(const QRectF& scene, const View& view, const Eigen::Vector3d& place) {
  const double scale = scene.height() / view.height;
  const Eigen::Vector3d offset = place - view.centre;
  return scene.center() + QPointF(scale * offset.dot(view.right), -scale * offset.dot(view.up));
}

QColor colour_of(MarkKind kind) {
  if (kind == MarkKind::kFault) return {200, 30, 30};
  return kind == MarkKind::kCare ? QColor(222, 120, 0) : QColor(20, 95, 170);
}

constexpr double kNumberRadius = 17, kDotRadius = 7;

void draw_number(QPainter& painter, const QPointF& at, std::size_t number, const QColor& colour) {
  painter.setPen(QPen(Qt::white, 2));
  painter.setBrush(colour);
  painter.drawEllipse(at, kNumberRadius, kNumberRadius);
  painter.setPen(Qt::white);
  painter.setFont(text_font(22, true));
  painter.drawText(QRectF(at.x() - 20, at.y() - 20, 40, 40), Qt::AlignCenter, QString::number(number));
}

/// Dots at every place; those of the first finding lie on top.
std::vector<std::vector<QPointF>> draw_dots(QPainter& painter, const QRectF& scene, const View& view,
                                            const std::vector<FindingMark>& findings) {
  std::vector<std::vector<QPointF>> marks(findings.size());
  for (std::size_t k = findings.size(); k-- > 0;) {
    for (const auto& place : findings[k].places) marks[k].push_back(place_on(scene, view, place));
    painter.setPen(QPen(Qt::white, 1.5));
    painter.setBrush(colour_of(findings[k].kind));
    for (const auto& dot : marks[k]) painter.drawEllipse(dot, kDotRadius, kDotRadius);
  }
  return marks;
}

/// Numbers of the first findings, those `explained`, beside their first dots: within the scene, off each
/// other and off other dots.
std::vector<QRectF> draw_numbers(QPainter& painter, const QRectF& scene, std::size_t explained,
                                 const std::vector<FindingMark>& findings,
                                 const std::vector<std::vector<QPointF>>& marks) {
  std::vector<LabelledPoint> points;
  std::vector<std::size_t> numbered;
  std::vector<QRectF> taken;
  for (std::size_t k = 0; k < marks.size(); ++k) {
    for (const QPointF& dot : marks[k])
      taken.emplace_back(dot.x() - kDotRadius, dot.y() - kDotRadius, 2 * kDotRadius, 2 * kDotRadius);
    if (marks[k].empty() || k >= explained) continue;
    points.push_back({marks[k].front(), QSizeF(2 * kNumberRadius, 2 * kNumberRadius), kDotRadius});
    numbered.push_back(k);
  }
  const auto labels = place_labels(points, scene.adjusted(4, 4, -4, -4), taken);
  for (std::size_t n = labels.size(); n-- > 0;) {
    const QColor colour = colour_of(findings[numbered[n]].kind);
    painter.setPen(QPen(colour, 3));
    painter.drawLine(points[n].at, labels[n].center());
    draw_number(painter, labels[n].center(), numbered[n] + 1, colour);
  }
  return labels;
}

/// Words, each shortened where it alone is wider than a line.
QString breakable(const std::string& words, double width, const QFont& font) {
  QStringList each = QString::fromStdString(words).split(' ');
  for (QString& word : each) word = QFontMetricsF(font).elidedText(word, Qt::ElideRight, width);
  return each.join(' ');
}

/// A number and its words for each finding, as many as there is room for; returns where they stand.
std::vector<QRectF> draw_legend(QPainter& painter, const QRectF& area,
                                const std::vector<FindingMark>& findings) {
  constexpr double kBesideNumber = 48, kBetween = 14, kMinHeight = 40;
  constexpr int kFlags = Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap;
  const QFont font = text_font(kNotePixels);
  std::vector<QRectF> lines;
  double top = area.top();
  for (std::size_t k = 0; k < findings.size(); ++k) {
    const QString words = breakable(findings[k].words, area.width() - kBesideNumber, font);
    QRectF space(area.left() + kBesideNumber, top + 4, area.width() - kBesideNumber, area.height());
    space.setHeight(QFontMetricsF(font).boundingRect(space, kFlags, words).height());
    const double height = std::max(kMinHeight, 4 + space.height());
    painter.setFont(font);
    painter.setPen(Qt::black);
    // The last line that fits says how many findings do not.
    const bool is_last = k + 1 == findings.size();
    if (k >= kMaxLines || top + height + (is_last ? 0 : kBetween + kMinHeight) > area.bottom()) {
      painter.drawText(QRectF(area.left(), top, area.width(), kMinHeight), Qt::AlignLeft | Qt::AlignVCenter,
                       QStringLiteral("and %1 more").arg(findings.size() - k));
      break;
    }
    painter.drawText(space, kFlags, words);
    draw_number(painter, {area.left() + 18, top + 20}, k + 1, colour_of(findings[k].kind));
    lines.emplace_back(area.left(), top, area.width(), height);
    top += height + kBetween;
  }
  return lines;
}

}  // namespace

FindingsPicture compose_findings(const std::vector<MarkedPart>& parts,
                                 const std::vector<FindingMark>& findings, const std::string& title) {
  FindingsPicture picture;
  picture.image = white_canvas(kWidth, kHeight);
  QPainter painter(&picture.image);
  painter.setRenderHints(QPainter::Antialiasing | QPainter::TextAntialiasing);
  const Heading heading(title, "red: error, orange: warning, blue: information", kWidth - 2 * kMargin);
  heading.draw(painter, kMargin, kMargin - 8);
  const double top = std::round(kMargin + heading.height() + 12);
  const QRectF scene(kMargin, top, kWidth - 3 * kMargin - kLegendWidth, kHeight - top - kMargin);
  const View view = view_of(parts, scene.width() / scene.height());
  painter.drawImage(scene.topLeft(), draw_parts(parts, view, scene.toRect().size()));
  painter.setPen(QPen(QColor(150, 150, 150), 1.5));
  painter.setBrush(Qt::NoBrush);
  painter.drawRect(scene);
  picture.marks = draw_dots(painter, scene, view, findings);
  picture.legend =
      draw_legend(painter, QRectF(scene.right() + kMargin, top, kLegendWidth, scene.height()), findings);
  picture.numbers = draw_numbers(painter, scene, picture.legend.size(), findings, picture.marks);
  return picture;
}

void draw_findings(const std::filesystem::path& png, const std::vector<MarkedPart>& parts,
                   const std::vector<FindingMark>& findings, const std::string& title) {
  write_png(png, compose_findings(parts, findings, title).image);
}

}  // namespace diefill::render
