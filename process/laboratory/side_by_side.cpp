#include "process/laboratory/side_by_side.h"

#include <mutex>
#include <numeric>
#include <vector>

#include "engine/numerics/thread_pool.h"

namespace diefill::process::laboratory {

namespace {

/// Progress of all pieces; may be reported from any thread.
class Shares {
 public:
  Shares(const ProgressCallback& on_progress, std::size_t pieces, const std::string& doing)
      : on_progress_(on_progress), doing_(doing), done_(pieces) {}
  void set(std::size_t piece, double share) {
    const std::lock_guard lock(mutex_);
    finished_ += share >= 1 && done_[piece] < 1;
    done_[piece] = share;
    const double all = std::accumulate(done_.begin(), done_.end(), 0.0);
    on_progress_(all / static_cast<double>(done_.size()),
                 doing_ + ", " + std::to_string(finished_) + " of " + std::to_string(done_.size()) + " done");
  }

 private:
  const ProgressCallback& on_progress_;
  std::string doing_;
  std::vector<double> done_;
  std::size_t finished_ = 0;
  std::mutex mutex_;
};

}  // namespace

void side_by_side(const ExperimentOptions& options, std::size_t pieces, const std::string& doing,
                  const std::function<void(std::size_t piece, const ShareCallback& on_progress)>& work) {
  Shares shares(options.on_progress, pieces, doing);
  engine::ThreadPool(options.threads).for_each(pieces, [&](std::size_t piece) {
    work(piece, [&](double share) { shares.set(piece, share); });
    shares.set(piece, 1);
  });
}

}  // namespace diefill::process::laboratory
