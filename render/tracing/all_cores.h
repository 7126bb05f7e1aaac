// A loop on all cores, for files that should not include oneTBB.
#pragma once

#include <functional>

namespace diefill::render {

/// Calls `work(n)` for all n below `count`; returns when all are done.
void on_all_cores(int count, const std::function<void(int)>& work);

}  // namespace diefill::render
