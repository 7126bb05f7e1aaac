// Fillings that several tests need are computed once for all of them: each test is a process of its own.
#pragma once

#include <nlohmann/json.hpp>

#include "tests/app/small_die.h"

namespace diefill::app {

/// The report of the scene as it stands in `die`. Kept beside the program for the next test that asks for the
/// same scene and tools, as long as the program is the same; empty where the run fails. Whether a run gives
/// the same twice is for other tests to find out (Run.GivesTheSameStateWithOneThreadAndTwo).
nlohmann::json shared_report(const SmallDie& die);

}  // namespace diefill::app
