// Work on all cores at once, for surfaces of millions of triangles.
#pragma once

#include <cstddef>
#include <functional>

namespace diefill::geometry {

/// Calls `work(i)` for all i below `count`, on all cores; returns when all are done. What was written before
/// is seen by the work, and what the work writes is seen afterwards.
void on_all_cores(std::size_t count, const std::function<void(std::size_t)>& work);

/// Calls `work(begin, end)` for parts of the numbers below `count`, on all cores, each number in one part.
/// Where parts begin follows from the count alone.
void in_parts_on_all_cores(std::size_t count, const std::function<void(std::size_t, std::size_t)>& work);

/// Calls both, if there is a core for each at the same time; otherwise like on_all_cores().
void side_by_side(const std::function<void()>& one, const std::function<void()>& other);

}  // namespace diefill::geometry
