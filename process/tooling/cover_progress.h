// Progress of covering tools with wall spheres in parallel.
#pragma once

#include <atomic>
#include <future>
#include <string>
#include <vector>

#include "geometry/wall_spheres/wall_spheres.h"
#include "process/tooling/progress.h"

namespace diefill::process {

/// Each tool counts by its triangles; the thread that covers it reports its progress.
class CoverProgress {
 public:
  struct Part {
    std::string tool;
    double triangles = 0;
  };
  explicit CoverProgress(const std::vector<Part>& parts);

  /// Reports the completed share of tool k (by number in `parts`), 0 to 1.
  void done(std::size_t k, double share) { shares_[k].store(share, std::memory_order_relaxed); }

  /// Waits for the spheres of tool k and meanwhile reports the completed share of all, `from` to 1.
  geometry::WallSpheres wait_for(std::size_t k, std::future<geometry::WallSpheres>& spheres, double from,
                                 const ProgressCallback& on_progress) const;

 private:
  double share_of_all() const;

  std::vector<Part> parts_;
  std::vector<std::atomic<double>> shares_;
  double all_triangles_ = 0;
};

}  // namespace diefill::process
