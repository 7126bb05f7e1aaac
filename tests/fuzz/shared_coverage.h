// Lets the fuzzer see what its child processes cover.
#pragma once

namespace diefill::geometry::fuzz {

/// Puts the coverage counters of this program into memory that processes forked later count in as well. Call
/// once, before any fork. Throws std::runtime_error where the system does not let it.
void share_coverage_with_children();

}  // namespace diefill::geometry::fuzz
