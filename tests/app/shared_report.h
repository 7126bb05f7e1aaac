// What several tests need is computed once for all of them: each test is a process of its own. It is kept
// beside the program, as long as the program is the same. Whether a run gives the same twice is for other
// tests to find out (Run.GivesTheSameStateWithOneThreadAndTwo).
#pragma once

#include <functional>
#include <nlohmann/json.hpp>

#include "tests/app/small_die.h"

namespace diefill::app {

/// The report of the scene as it stands in `die`; empty where the run fails.
nlohmann::json shared_report(const SmallDie& die);

/// Puts the results of the scene as it stands in `die`, without pictures, where run() puts its results.
/// Throws std::runtime_error where the run fails.
void take_shared_results(const SmallDie& die);

/// A folder that `fill` has filled for the files in `die` and for `what`; nobody changes it. What `fill`
/// throws leaves nothing behind.
std::filesystem::path shared_folder(const SmallDie& die, const std::string& what,
                                    const std::function<void(const std::filesystem::path& folder)>& fill);

}  // namespace diefill::app
