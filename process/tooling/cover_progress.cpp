#include "process/tooling/cover_progress.h"

#include <algorithm>
#include <chrono>

namespace diefill::process {

namespace {

constexpr std::chrono::milliseconds kPollInterval(50);
constexpr double kOfSmallTool = 1e4;  // triangles that any tool counts as, at least

}  // namespace

CoverProgress::CoverProgress(const std::vector<Part>& parts) : parts_(parts), shares_(parts.size()) {
  for (Part& part : parts_) all_triangles_ += part.triangles = std::max(part.triangles, kOfSmallTool);
}

double CoverProgress::share_of_all() const {
  double covered = 0;
  for (std::size_t k = 0; k < parts_.size(); ++k)
    covered += parts_[k].triangles * shares_[k].load(std::memory_order_relaxed);
  return covered / all_triangles_;
}

geometry::WallSpheres CoverProgress::wait_for(std::size_t k, std::future<geometry::WallSpheres>& spheres,
                                              double from, const ProgressCallback& on_progress) const {
  do {
    on_progress(from + (1 - from) * share_of_all(), "covering \"" + parts_[k].tool + "\" with wall spheres");
  } while (spheres.wait_for(kPollInterval) != std::future_status::ready);
  return spheres.get();
}

}  // namespace diefill::process
