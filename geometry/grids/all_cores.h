// Parallel loops over surfaces of millions of triangles.
#pragma once

#include <cstddef>
#include <functional>

namespace diefill::geometry {

/// Calls `work(i)` for all i below `count`, on all cores; returns when all are done. Memory written before is
/// visible to the work, and what the work writes is visible afterwards.
void on_all_cores(std::size_t count, const std::function<void(std::size_t)>& work);

/// Calls `work(begin, end)` for ranges of the numbers below `count`, on all cores, each number in one range.
/// The ranges depend on the count alone.
void in_parts_on_all_cores(std::size_t count, const std::function<void(std::size_t, std::size_t)>& work);

/// Calls both, if there is a core for each at the same time; otherwise like on_all_cores().
void side_by_side(const std::function<void()>& one, const std::function<void()>& other);

}  // namespace diefill::geometry
