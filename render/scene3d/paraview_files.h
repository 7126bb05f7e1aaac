// Results as files that ParaView and other VTK programs open.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "process/results/fill_result.h"

namespace diefill::render {

/// Values that points carry.
struct PointArray {
  std::string name;    ///< with its unit, such as "velocity [m/s]"
  int components = 1;  ///< numbers a point
  std::vector<double> values;
};

/// Writes points (m) with their values as .vtp: one vertex each. Files are written whole or not at all.
/// Throws std::invalid_argument where an array has another number of values than points times components.
void write_points(const std::filesystem::path& file, const std::vector<Eigen::Vector3d>& points,
                  const std::vector<PointArray>& arrays);

/// A grid of points along x, y and z; x runs fastest.
struct PointGrid {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();  ///< m, its first point
  double spacing = 0;                                ///< m
  Eigen::Vector3i counts = Eigen::Vector3i::Ones();  ///< points along each axis
  Eigen::Vector3d point(int x, int y, int z) const { return origin + spacing * Eigen::Vector3d(x, y, z); }
  std::size_t size() const { return static_cast<std::size_t>(counts.cast<long>().prod()); }
};

/// Writes values on a grid as .vti, under the same rules.
void write_grid(const std::filesystem::path& file, const PointGrid& grid,
                const std::vector<PointArray>& arrays);

/// The same with values in cells: `grid` has its first corner as origin and `counts` cells along each axis.
void write_cells(const std::filesystem::path& file, const PointGrid& grid,
                 const std::vector<PointArray>& arrays);

/// Writes tools (m) as one .vtp; "tool" counts them from `first`, in the order of the results.
void write_tools(const std::filesystem::path& file, const std::vector<results::ToolState>& tools,
                 int first = 0);

/// One file of a series: when it is shown, and as which part of the whole. Parts of one instant are shown
/// together; a file may stand for several instants.
struct SeriesFile {
  double time = 0;   ///< s
  int part = 0;      ///< counted from 0
  std::string name;  ///< of the part, for people
  std::string file;  ///< seen from the series' own folder
};

/// Writes a .pvd file, which ParaView opens as all of `files` at once and plays over time.
void write_series(const std::filesystem::path& file, const std::vector<SeriesFile>& files);

}  // namespace diefill::render
