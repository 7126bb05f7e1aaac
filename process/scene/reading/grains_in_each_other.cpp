#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <unordered_map>

#include "process/input/scene_error.h"
#include "process/scene/reading/read_sphere_file.h"

namespace diefill::process {
namespace {

constexpr double kMaxOverlap = 0.5;  // of the smaller radius

using Cell = std::array<std::int64_t, 3>;

struct HashOfCell {
  std::size_t operator()(const Cell& cell) const {
    constexpr std::uint64_t kX = 73856093, kY = 19349663, kZ = 83492791;
    return static_cast<std::size_t>((static_cast<std::uint64_t>(cell[0]) * kX) ^
                                    (static_cast<std::uint64_t>(cell[1]) * kY) ^
                                    (static_cast<std::uint64_t>(cell[2]) * kZ));
  }
};

/// Grains whose radius is from 2^level to twice that, in cells as wide as the largest of them.
class Level {
 public:
  explicit Level(int level) : width_(std::ldexp(4.0, level)) {}

  void add(const engine::ClumpSphere& grain, std::size_t index) {
    grains_[cell_at(grain.centre)].push_back(index);
  }
  /// Index of a grain that is in `grain`; `spheres.size()` where none is.
  std::size_t in(const engine::ClumpSphere& grain, const std::vector<engine::ClumpSphere>& spheres) const {
    const Eigen::Vector3d reach = Eigen::Vector3d::Constant(grain.radius + 0.5 * width_);
    const Cell low = cell_at(grain.centre - reach), high = cell_at(grain.centre + reach);
    for (Cell cell = low; cell[0] <= high[0]; ++cell[0])
      for (cell[1] = low[1]; cell[1] <= high[1]; ++cell[1])
        for (cell[2] = low[2]; cell[2] <= high[2]; ++cell[2]) {
          const auto found = grains_.find(cell);
          if (found == grains_.end()) continue;
          for (const std::size_t other : found->second)
            if (are_in_each_other(grain, spheres[other])) return other;
        }
    return spheres.size();
  }

 private:
  Cell cell_at(const Eigen::Vector3d& point) const {
    Cell cell{};
    for (int axis = 0; axis < 3; ++axis)
      cell[static_cast<std::size_t>(axis)] = static_cast<std::int64_t>(std::floor(point[axis] / width_));
    return cell;
  }
  static bool are_in_each_other(const engine::ClumpSphere& a, const engine::ClumpSphere& b) {
    const double overlap = a.radius + b.radius - (a.centre - b.centre).norm();
    return overlap > kMaxOverlap * std::min(a.radius, b.radius);
  }

  double width_;
  std::unordered_map<Cell, std::vector<std::size_t>, HashOfCell> grains_;
};

}  // namespace

void refuse_grains_in_each_other(const SphereRows& grains, const std::filesystem::path& file) {
  const auto& spheres = grains.spheres;
  std::vector<std::size_t> order(spheres.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  // The large ones first: a grain asks those of its own level and above, whose cells are not many.
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return spheres[a].radius > spheres[b].radius; });
  std::map<int, Level> levels;
  for (const std::size_t index : order) {
    for (const auto& [number, level] : levels) {
      const std::size_t other = level.in(spheres[index], spheres);
      if (other == spheres.size()) continue;
      const auto [first, second] = std::minmax(grains.lines[index], grains.lines[other]);
      throw SceneError(file.string() + ':' + std::to_string(second) + ": this grain overlaps that of line " +
                       std::to_string(first) +
                       " by more than half the smaller radius; remove one of the two, or give grains that "
                       "only touch");
    }
    const int level = std::ilogb(spheres[index].radius);
    levels.try_emplace(level, level).first->second.add(spheres[index], index);
  }
}

}  // namespace diefill::process
