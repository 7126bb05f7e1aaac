// Work on many pictures at once, each share in a process of its own: a drawing context belongs to one
// process.
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>

namespace diefill::app {

/// Calls `work` for every number below `count`, in `jobs` processes that see memory as it is now and leave no
/// trace in it. Only where nothing has been drawn yet: forks have none of the threads that drawing starts.
/// They end with this process, however that ends. Throws std::runtime_error where one fails; it has said why
/// on standard error. Throws process::Interrupted, once they have ended, where `stop` is set.
void in_processes(std::size_t count, std::size_t jobs, const std::atomic<bool>& stop,
                  const std::function<void(std::size_t)>& work);

}  // namespace diefill::app
