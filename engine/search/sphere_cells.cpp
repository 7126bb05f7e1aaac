#include "engine/search/sphere_cells.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <numeric>

#include "engine/numerics/shared_ranges.h"

namespace diefill::engine {

namespace {

/// Cells per point, and some to start with, at most.
constexpr double kCellsPerPoint = 8, kFewCells = 4096;
/// Cells at most: those along an edge are counted in an int, and all of them in 32 bits.
constexpr double kMostCells = std::numeric_limits<int>::max();
/// Points that a thread takes at a time, and shares of the cells for each thread; they change no result.
constexpr std::size_t kPointsAtATime = 16384, kSharesPerThread = 4;

}  // namespace

CellNumbers cells_for(const Eigen::Vector3d& extents, double cell, std::size_t points) {
  const auto cells_at = [&](double edge) { return Eigen::Vector3d((extents / edge).array().floor() + 1); };
  const double most = std::min(kFewCells + kCellsPerPoint * static_cast<double>(points), kMostCells);
  double edge = cell;
  while (cells_at(edge).prod() > most) edge *= 1.25;
  return {cells_at(edge).cast<int>(), edge};
}

void SphereCells::build(const SphereField& spheres, double cell, ThreadPool& pool) {
  std::vector<std::uint32_t> all(spheres.size());
  std::iota(all.begin(), all.end(), 0U);
  build(spheres, std::move(all), cell, pool);
}

void SphereCells::build(const SphereField& spheres, std::vector<std::uint32_t> members, double cell,
                        ThreadPool& pool) {
  members_ = std::move(members);
  choose_cells(spheres, cell, pool);
  cell_.resize(members_.size());
  in_runs(members_.size(), kPointsAtATime, pool, [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t k = begin; k < end; ++k) {
      const Eigen::Vector3i place = cell_of(spheres.position(members_[k]));
      cell_[k] = static_cast<std::uint32_t>(index_of(place[0], place[1], place[2]));
    }
  });
  fill(spheres, pool);
}

/// Cells of at least `cell` (m) about all members, all of them empty.
void SphereCells::choose_cells(const SphereField& spheres, double cell, ThreadPool& pool) {
  std::vector<Eigen::AlignedBox3d> boxes(runs_in(members_.size(), kPointsAtATime));
  in_runs(members_.size(), kPointsAtATime, pool, [&](std::size_t begin, std::size_t end, std::size_t run) {
    Eigen::AlignedBox3d box;
    for (std::size_t k = begin; k < end; ++k) box.extend(eigen(spheres.position(members_[k])));
    boxes[run] = box;
  });
  Eigen::AlignedBox3d box;
  for (const auto& part : boxes) box.extend(part);
  if (members_.empty()) box.extend(Eigen::Vector3d(Eigen::Vector3d::Zero()));
  lower_ = box.min();
  const CellNumbers chosen = cells_for(box.max() - lower_, cell, members_.size());
  edge_ = chosen.edge;
  cells_ = chosen.cells;
  first_.assign(index_of(cells_[0] - 1, cells_[1] - 1, cells_[2] - 1) + 2, 0);
}

/// Calls use(k) for the places k of all members: those of a cell in their order, by one thread.
template <class Use>
void SphereCells::for_members_by_cell(ThreadPool& pool, const Use& use) const {
  const std::size_t threads = static_cast<std::size_t>(pool.threads());
  const std::size_t shares = threads == 1 ? 1 : threads * kSharesPerThread;
  in_shares(cells(), shares, pool, [&](Share share) {
    for (std::size_t k = 0; k < cell_.size(); ++k)
      if (share.has(cell_[k])) use(k);
  });
}

void SphereCells::fill(const SphereField& spheres, ThreadPool& pool) {
  for_members_by_cell(pool, [&](std::size_t k) { ++first_[cell_[k] + 1]; });
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  member_.resize(members_.size());
  position_.resize(members_.size());
  std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
  for_members_by_cell(pool, [&](std::size_t k) {
    const std::uint32_t place = next[cell_[k]]++;
    member_[place] = {members_[k], static_cast<std::uint32_t>(spheres.owner(members_[k]))};
    position_[place] = spheres.position(members_[k]);
  });
}

}  // namespace diefill::engine
