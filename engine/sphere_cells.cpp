#include "engine/sphere_cells.h"

#include <numeric>

namespace diefill::engine {

namespace {

/// A few far-flung grains must not cost a huge empty grid: at most this many cells a point (and some to start
/// with).
constexpr double kCellsPerPoint = 8, kFewCells = 4096;

}  // namespace

void SphereCells::build(const SphereField& spheres, double cell) {
  members_.resize(spheres.size());
  std::iota(members_.begin(), members_.end(), 0U);
  build(spheres, std::move(members_), cell);
}

void SphereCells::build(const SphereField& spheres, std::vector<std::uint32_t> members, double cell) {
  members_ = std::move(members);
  lower_ = Eigen::Vector3d::Constant(1e300);
  Eigen::Vector3d upper = -lower_;
  for (const std::uint32_t k : members_) {
    const Eigen::Vector3d point = eigen(spheres.position(k));
    lower_ = lower_.cwiseMin(point);
    upper = upper.cwiseMax(point);
  }
  if (members_.empty()) lower_ = upper = Eigen::Vector3d::Zero();
  edge_ = cell;
  const auto cells_at = [&](double edge) {
    return Eigen::Vector3d(((upper - lower_) / edge).array().floor() + 1);
  };
  const double most = kFewCells + kCellsPerPoint * static_cast<double>(members_.size());
  while (cells_at(edge_).prod() > most) edge_ *= 1.25;
  cells_ = cells_at(edge_).cast<int>();

  first_.assign(index_of(cells_[0] - 1, cells_[1] - 1, cells_[2] - 1) + 2, 0);
  cell_.resize(members_.size());
  for (std::size_t k = 0; k < members_.size(); ++k) {
    const Eigen::Vector3i place = cell_of(spheres.position(members_[k]));
    cell_[k] = static_cast<std::uint32_t>(index_of(place[0], place[1], place[2]));
    ++first_[cell_[k] + 1];
  }
  std::partial_sum(first_.begin(), first_.end(), first_.begin());

  member_.resize(members_.size());
  position_.resize(members_.size());
  std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
  for (std::size_t k = 0; k < members_.size(); ++k) {
    const std::uint32_t place = next[cell_[k]]++;
    member_[place] = {members_[k], static_cast<std::uint32_t>(spheres.owner(members_[k]))};
    position_[place] = spheres.position(members_[k]);
  }
}

}  // namespace diefill::engine
