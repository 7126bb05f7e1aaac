#include "process/laboratory/benchmark_bed.h"

#include <zlib.h>

#include <array>
#include <charconv>
#include <cmath>

#include "engine/laws/bierwisch_law.h"
#include "engine/powder/sphere_volume.h"
#include "process/results/storage/result_file.h"

namespace diefill::process::laboratory {

namespace {

constexpr double kDensity = 5400;                                 // kg/m^3
constexpr double kSphereRadius = 1.5e-4, kClumpRadius = 7.84e-5;  // m
constexpr double kSphereBox = 0.012, kClumpBox = 0.007;           // m

double mass_of_sphere(double radius) {
  return engine::sphere_mass(kDensity, radius);
}

/// Lines of a plain or gzip file.
std::vector<std::string> lines_of(const std::filesystem::path& path) {
  constexpr std::size_t kMaxLines = 20'000'000;
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error))
    throw results::ResultError(path.string() + ": not a regular file; give a CSV file, plain or gzip");
  gzFile file = gzopen(path.c_str(), "rb");
  if (!file) throw results::ResultError(path.string() + ": cannot be opened; check its permissions");
  std::vector<std::string> lines;
  std::array<char, 4096> buffer;
  while (lines.size() <= kMaxLines && gzgets(file, buffer.data(), static_cast<int>(buffer.size())))
    lines.emplace_back(buffer.data());
  int problem = 0;
  gzerror(file, &problem);
  gzclose(file);
  if (lines.size() > kMaxLines)
    throw results::ResultError(path.string() + ": more lines than the allowed " + std::to_string(kMaxLines) +
                               "; use a smaller bed");
  if (problem != Z_OK && problem != Z_STREAM_END)
    throw results::ResultError(path.string() + ": damaged gzip file; copy it again");
  return lines;
}

/// The numbers of a line of `columns` comma-separated ones.
std::vector<double> numbers_of(const std::string& line, std::size_t columns, const std::string& where) {
  std::vector<double> numbers;
  const char *at = line.data(), *end = line.data() + line.find_last_not_of("\r\n") + 1;
  while (at < end) {
    double value = 0;
    const auto [next, error] = std::from_chars(at, end, value);
    if (error != std::errc()) break;
    numbers.push_back(value);
    at = next + 1;
  }
  if (numbers.size() != columns)
    throw results::ResultError(where + ": " + std::to_string(columns) + " numbers per line expected, found " +
                               std::to_string(numbers.size()));
  return numbers;
}

}  // namespace

BenchmarkBedState empty_benchmark_bed(BenchmarkBed kind, double width) {
  const double radius = kind == BenchmarkBed::spheres ? kSphereRadius : kClumpRadius;
  BenchmarkBedState bed;
  auto& settings = bed.settings;
  settings.types = {{kind == BenchmarkBed::spheres ? engine::model_b(radius, mass_of_sphere(radius))
                                                   : engine::model_d(radius, 7 * mass_of_sphere(radius))}};
  const auto law =
      engine::laws::bierwisch_law({.damping = 1e6 * radius, .tangential = 1e6 * radius, .friction = 0.5});
  settings.contact = engine::one_powder(law, law);
  settings.time_step = 2e-6;
  settings.period = {width, width};
  engine::WallBodySpec floor;
  floor.name = "floor";
  floor.planes = {{Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitZ()}};
  bed.walls = {floor};
  return bed;
}

BenchmarkBedState read_benchmark_bed(BenchmarkBed kind, const std::filesystem::path& file, double width) {
  if (!(width > 0)) width = kind == BenchmarkBed::spheres ? kSphereBox : kClumpBox;
  BenchmarkBedState bed = empty_benchmark_bed(kind, width);
  const auto lines = lines_of(file);
  const std::size_t columns = kind == BenchmarkBed::spheres ? 10 : 14;
  for (std::size_t k = 1; k < lines.size(); ++k) {
    const auto row = numbers_of(lines[k], columns, file.string() + ", line " + std::to_string(k + 1));
    engine::NewGrain grain;
    std::size_t at = 1;
    const auto vector = [&] {
      at += 3;
      return Eigen::Vector3d(row[at - 3], row[at - 2], row[at - 1]);
    };
    grain.position = vector() - Eigen::Vector3d(0.5 * width, 0.5 * width, 0);
    if (kind == BenchmarkBed::clumps) {
      grain.orientation = {row[at], row[at + 1], row[at + 2], row[at + 3]};
      at += 4;
    }
    grain.velocity = vector();
    grain.angular_velocity = vector();
    bed.grains.push_back(grain);
  }
  if (bed.grains.empty()) throw results::ResultError(file.string() + ": contains no grains");
  return bed;
}

BenchmarkBedState side_by_side(const BenchmarkBedState& bed, int copies) {
  BenchmarkBedState all = bed;
  all.grains.clear();
  const double width_x = bed.settings.period[0].value(), width_y = bed.settings.period[1].value();
  all.settings.period = {copies * width_x, copies * width_y};
  for (int j = 0; j < copies; ++j)
    for (int i = 0; i < copies; ++i)
      for (engine::NewGrain grain : bed.grains) {
        grain.position.x() += (i - 0.5 * (copies - 1)) * width_x;
        grain.position.y() += (j - 0.5 * (copies - 1)) * width_y;
        all.grains.push_back(grain);
      }
  return all;
}

BenchmarkBedState loose_benchmark_bed(BenchmarkBed kind, std::size_t spheres) {
  const std::size_t per_grain = kind == BenchmarkBed::spheres ? 1 : 7;
  const double radius = kind == BenchmarkBed::spheres ? kSphereRadius : 3 * kClumpRadius;
  const double constant = 2.1 * radius;
  const auto grains = static_cast<double>(spheres) / static_cast<double>(per_grain);
  const int across = std::max(4, static_cast<int>(std::lround(std::cbrt(grains))));
  const int layers = std::max(1, static_cast<int>(std::lround(grains / (across * across))));
  BenchmarkBedState bed = empty_benchmark_bed(kind, across * constant);
  for (int k = 0; k < layers; ++k)
    for (int j = 0; j < across; ++j)
      for (int i = 0; i < across; ++i) {
        engine::NewGrain grain;
        grain.position = constant * Eigen::Vector3d(i + 0.5 - 0.5 * across, j + 0.5 - 0.5 * across, k + 0.5);
        grain.orientation = engine::Quaternion(1, 0.3 * i, 0.2 * j, 0.1 * k).normalized();
        // Sideways speeds, so that columns do not stay on each other.
        grain.velocity = 0.02 * Eigen::Vector3d(std::sin(3.0 * i + 5.0 * k), std::sin(7.0 * j + 2.0 * k), 0);
        bed.grains.push_back(grain);
      }
  return bed;
}

}  // namespace diefill::process::laboratory
