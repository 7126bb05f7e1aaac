#include "process/laboratory/side_by_side.h"

#include <mutex>
#include <numeric>
#include <vector>

#include "engine/numerics/thread_pool.h"

namespace diefill::process::laboratory {

namespace {

/// How far all pieces are; told of from any thread, one at a time.
class Shares {
 public:
  Shares(const TellProgress& tell, std::size_t pieces, const std::string& doing)
      : tell_(tell), doing_(doing), done_(pieces) {}
  void tell(std::size_t piece, double share) {
    const std::lock_guard lock(mutex_);
    finished_ += share >= 1 && done_[piece] < 1;
    done_[piece] = share;
    const double all = std::accumulate(done_.begin(), done_.end(), 0.0);
    tell_(all / static_cast<double>(done_.size()),
          doing_ + ", " + std::to_string(finished_) + " of " + std::to_string(done_.size()) + " done");
  }

 private:
  const TellProgress& tell_;
  std::string doing_;
  std::vector<double> done_;
  std::size_t finished_ = 0;
  std::mutex mutex_;
};

}  // namespace

void side_by_side(const ExperimentOptions& options, std::size_t pieces, const std::string& doing,
                  const std::function<void(std::size_t piece, const TellShare& tell)>& work) {
  Shares shares(options.tell, pieces, doing);
  engine::ThreadPool(options.threads).for_each(pieces, [&](std::size_t piece) {
    work(piece, [&](double share) { shares.tell(piece, share); });
    shares.tell(piece, 1);
  });
}

}  // namespace diefill::process::laboratory
