#include "render/report/viewer/packed_run.h"

#include <Eigen/Geometry>
#include <QJsonArray>
#include <cmath>

#include "render/report/viewer/packed_bytes.h"
#include "render/report/viewer/packed_frames.h"
#include "render/report/viewer/shown_grains.h"

namespace diefill::render::report {
namespace {

constexpr double kMillimetre = 1e3;
constexpr double kFractionSteps = 5000;

QString text_of(const std::string& text) {
  return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

QJsonArray point_of(const Eigen::Vector3d& metres) {
  return {kMillimetre * metres.x(), kMillimetre * metres.y(), kMillimetre * metres.z()};
}

QJsonArray sphere_of(const Eigen::Vector3d& offset, double radius) {
  auto sphere = point_of(offset);
  sphere.append(kMillimetre * radius);
  return sphere;
}

/// Spheres of a grain of each kind: centre in the body frame and radius, mm.
QJsonArray shapes_of(const results::PowderState& powder) {
  QJsonArray shapes;
  std::size_t next = 0;
  for (std::size_t kind = 0; kind < std::max<std::size_t>(1, powder.kinds.size()); ++kind) {
    QJsonArray spheres;
    const double radius = powder.monodisperse() ? powder.sphere_radius : powder.kinds.sphere_radius[kind];
    if (!powder.kinds.spheres.empty()) {
      for (std::uint32_t n = 0; n < powder.kinds.spheres[kind]; ++n, ++next)
        spheres.append(sphere_of(powder.kinds.sphere_offsets[next], powder.kinds.sphere_radii[next]));
    } else {
      const double scale = powder.sphere_radius > 0 ? radius / powder.sphere_radius : 1;
      for (std::size_t n = 0; n < powder.sphere_offsets.size(); ++n)
        spheres.append(sphere_of(scale * powder.sphere_offsets[n],
                                 powder.sphere_radii.empty() ? radius : scale * powder.sphere_radii[n]));
    }
    const double diameter = powder.monodisperse() ? powder.grain_diameter : powder.kinds.diameter[kind];
    shapes.append(QJsonObject{{"diameter", kMillimetre * diameter}, {"spheres", spheres}});
  }
  return shapes;
}

/// Tools in their order; one of too many triangles is named without its mesh.
QJsonArray pack_tools(PackedBytes& bytes, const results::FillResult& result, std::size_t most) {
  QJsonArray tools;
  for (std::size_t n = 0; n < result.tools.size(); ++n) {
    const auto& tool = result.tools[n];
    const bool shown = tool.triangles.size() <= most && !tool.triangles.empty();
    tools.append(QJsonObject{{"name", text_of(tool.name)}, {"role", text_of(tool.role)}, {"shown", shown}});
    if (!shown) continue;
    std::vector<float> vertices;
    for (const auto& vertex : tool.vertices)
      for (int axis = 0; axis < 3; ++axis) vertices.push_back(static_cast<float>(kMillimetre * vertex[axis]));
    std::vector<std::uint32_t> corners;
    for (const auto& triangle : tool.triangles)
      for (int corner = 0; corner < 3; ++corner)
        corners.push_back(static_cast<std::uint32_t>(triangle[corner]));
    bytes.add("vertices" + std::to_string(n), vertices);
    bytes.add("corners" + std::to_string(n), corners);
  }
  return tools;
}

QJsonObject pack_density(PackedBytes& bytes, const DensityGrid& grid) {
  if (grid.value.empty()) return {};
  std::vector<std::uint16_t> words;
  for (const double value : grid.value)
    words.push_back(std::isfinite(value)
                        ? static_cast<std::uint16_t>(1 + std::lround(kFractionSteps * std::max(value, 0.0)))
                        : std::uint16_t{0});
  bytes.add("density", words);
  return {{"origin", point_of(grid.origin)},
          {"spacing", kMillimetre * grid.spacing},
          {"counts", QJsonArray{grid.counts.x(), grid.counts.y(), grid.counts.z()}},
          {"width", kMillimetre * grid.averaging_width}};
}

/// Corners of all cavities together.
QJsonObject cavities_of(const results::FillResult& result) {
  if (!(result.cavity.volume > 0)) return {};
  Eigen::AlignedBox3d box(result.cavity.lower_corner, result.cavity.upper_corner);
  for (const auto& cavity : result.other_cavities)
    if (cavity.volume > 0) box.extend(Eigen::AlignedBox3d(cavity.lower_corner, cavity.upper_corner));
  return {{"lower", point_of(box.min())}, {"upper", point_of(box.max())}};
}

std::string remark_of(const ShownGrains& shown, std::size_t kept, std::size_t packed,
                      const QJsonArray& tools) {
  std::string remark = shown.remark;
  const auto add_remark = [&](const std::string& words) { remark += (remark.empty() ? "" : " ") + words; };
  if (packed < kept)
    add_remark(std::to_string(packed) + " of " + std::to_string(kept) + " kept instants are shown.");
  for (const QJsonValue tool : tools) {
    const QJsonObject entry = tool.toObject();
    if (!entry["shown"].toBool())
      add_remark("Tool \"" + entry["name"].toString().toStdString() +
                 "\" has no mesh of a size that can be shown.");
  }
  return remark;
}

}  // namespace

PackedRun packed_run(const ViewedRun& run, const PackingLimits& limits) {
  const auto& result = *run.result;
  const auto instants = spread_instants(result.instants.size(), limits.instants);
  const ShownGrains shown = shown_grains(result, instants, limits.spheres);
  PackedBytes bytes;
  PackedRun packed;
  packed.description = pack_frames(bytes, run, instants, shown);
  packed.description["name"] = text_of(run.name);
  packed.description["strategy"] = text_of(result.strategy);
  packed.description["grains"] = static_cast<qint64>(shown.id.size());
  packed.description["spheres"] = static_cast<qint64>(shown.spheres);
  packed.description["shapes"] = shapes_of(result.powder);
  const auto tools = pack_tools(bytes, result, limits.triangles);
  packed.description["tools"] = tools;
  packed.description["remark"] = text_of(remark_of(shown, result.instants.size(), instants.size(), tools));
  packed.description["cavity"] = cavities_of(result);
  if (run.extras != nullptr) packed.description["density"] = pack_density(bytes, run.extras->density);
  std::vector<std::uint32_t> ids;
  for (const auto id : shown.id) ids.push_back(static_cast<std::uint32_t>(id));
  bytes.add("id", ids);
  bytes.add("kind", shown.kind);
  bytes.add("inside", shown.in_cavity);
  packed.description["arrays"] = bytes.table();
  packed.data = bytes.base64();
  return packed;
}

}  // namespace diefill::render::report
