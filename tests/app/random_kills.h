// Runs that are killed and go on, for tests with few kills (commands/resume_test.cpp) and with many
// (tests/slow).
#pragma once

#include <nlohmann/json.hpp>

namespace diefill::app {

/// Compares the reports of two runs that should have ended in the same state.
void expect_same_end(const nlohmann::json& unbroken, const nlohmann::json& broken);

/// Kills a run of the small die `kills` times, whatever it does at that moment (starting, pouring, stepping,
/// writing a checkpoint, measuring or drawing), and compares each end that it reaches with that of the
/// unbroken run. The moments are random, and the same in each call.
void expect_same_end_after_kills(int kills);

}  // namespace diefill::app
