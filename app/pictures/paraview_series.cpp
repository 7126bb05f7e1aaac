#include "app/pictures/paraview_series.h"

#include <algorithm>

#include "process/measure/earlier_instant.h"
#include "process/results/formatted.h"
#include "process/results/none.h"

namespace diefill::app {
namespace {

using render::PointArray;

PointArray vectors(const std::string& name, const std::vector<Eigen::Vector3d>& values) {
  PointArray array{name, 3, {}};
  for (const auto& value : values) array.values.insert(array.values.end(), value.begin(), value.end());
  return array;
}

template <class Value>
PointArray scalars(const std::string& name, std::size_t count, const Value& value) {
  PointArray array{name, 1, {}};
  for (std::size_t k = 0; k < count; ++k) array.values.push_back(value(k));
  return array;
}

std::string numbered(const char* format, std::size_t first, std::size_t second = 0) {
  return results::formatted(format, first, second);
}

/// Whether a tool stands where it stood, up to the rounding of its pose.
bool same_places(const std::vector<Eigen::Vector3d>& before, const std::vector<Eigen::Vector3d>& now) {
  constexpr double kRounding = 1e-9;  // m
  if (before.size() != now.size()) return false;
  for (std::size_t k = 0; k < now.size(); ++k)
    if ((before[k] - now[k]).cwiseAbs().maxCoeff() > kRounding) return false;
  return true;
}

/// Writes files into a folder and notes where they stand in the series.
class SeriesWriter {
 public:
  SeriesWriter(const std::filesystem::path& folder, const std::filesystem::path& series)
      : folder_(folder), series_(series), before_(folder.lexically_relative(series.parent_path())) {}

  void powder(const results::FillResult& then, const std::string& name) {
    render::write_points(folder_ / name, then.powder.position, grain_arrays(then));
    add(then.powder.time, 0, "powder", name);
    written_.push_back(folder_ / name);
  }

  /// A tool where it stands at an instant; the last file again where it has not moved.
  void tool(const results::ToolState& tool, std::size_t number, std::size_t instant, double time) {
    if (tool.triangles.empty()) return;
    last_.resize(std::max(last_.size(), number + 1));
    Shown& last = last_[number];
    if (!same_places(last.vertices, tool.vertices)) {
      last = {tool.vertices, numbered("tool_%zu_%04zu.vtp", number, instant)};
      render::write_tools(folder_ / last.file, {tool}, static_cast<int>(number));
      written_.push_back(folder_ / last.file);
    }
    add(time, static_cast<int>(number) + 1, tool.name, last.file);
  }

  void grid(const FieldWriter& write, const results::FillResult& then, const std::string& name) {
    write(then, folder_ / name);
    add(then.powder.time, static_cast<int>(then.tools.size()) + 1, "fields", name);
    written_.push_back(folder_ / name);
  }

  std::vector<std::filesystem::path> finish() {
    render::write_series(series_, files_);
    written_.push_back(series_);
    return std::move(written_);
  }

 private:
  struct Shown {
    std::vector<Eigen::Vector3d> vertices;
    std::string file;
  };

  void add(double time, int part, const std::string& name, const std::string& file) {
    files_.push_back({time, part, name, (before_ / file).lexically_normal().generic_string()});
  }

  std::filesystem::path folder_, series_, before_;
  std::vector<Shown> last_;
  std::vector<render::SeriesFile> files_;
  std::vector<std::filesystem::path> written_;
};

}  // namespace

std::vector<PointArray> grain_arrays(const results::FillResult& result) {
  const auto& powder = result.powder;
  const auto& fraction = result.solid_fraction;
  const std::size_t grains = powder.position.size();
  std::vector<PointArray> arrays = {
      scalars("id", grains, [&](std::size_t k) { return static_cast<double>(powder.id[k]); }),
      scalars("diameter [m]", grains, [&](std::size_t k) { return powder.diameter_of(k); }),
      vectors("velocity [m/s]", powder.velocity)};
  if (fraction.solid_fraction.size() == grains) {
    const auto closed = [&](std::size_t k, double value) { return fraction.open[k] != 0 ? kNone : value; };
    arrays.push_back(scalars("solid fraction", grains,
                             [&](std::size_t k) { return closed(k, fraction.solid_fraction[k]); }));
    arrays.push_back(
        scalars("in cavity", grains, [&](std::size_t k) { return fraction.in_cavity[k] != 0 ? 1.0 : 0.0; }));
    const auto& normal = result.contact_stress.normal;
    if (normal.size() == grains)
      arrays.push_back(scalars("pressure [Pa]", grains, [&](std::size_t k) {
        return closed(k, -normal[k].sum() / (3 * fraction.cell_volume[k]));
      }));
  }
  return arrays;
}

std::vector<std::filesystem::path> write_filling_series(const results::FillResult& result,
                                                        const std::filesystem::path& folder,
                                                        const std::filesystem::path& series,
                                                        const FieldWriter& fields,
                                                        const process::ProgressCallback& on_progress) {
  if (result.instants.empty()) return {};
  std::filesystem::create_directories(folder);
  SeriesWriter writer(folder, series);
  for (std::size_t n = 0; n < result.instants.size(); ++n) {
    on_progress(static_cast<double>(n) / static_cast<double>(result.instants.size()),
                "writing instant " + std::to_string(n + 1) + " of " + std::to_string(result.instants.size()));
    auto then = process::result_at(result, result.instants[n].time, static_cast<bool>(fields));
    then.contact_stress = {};  // known at the end alone
    writer.powder(then, numbered("powder_%04zu.vtp", n));
    for (std::size_t k = 0; k < then.tools.size(); ++k) writer.tool(then.tools[k], k, n, then.powder.time);
    if (fields) writer.grid(fields, then, numbered("fields_%04zu.vti", n));
  }
  writer.powder(result, "powder.vtp");
  for (std::size_t k = 0; k < result.tools.size(); ++k)
    writer.tool(result.tools[k], k, result.instants.size(), result.powder.time);
  if (fields) writer.grid(fields, result, "fields.vti");
  return writer.finish();
}

}  // namespace diefill::app
