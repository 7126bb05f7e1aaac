// What `plan --variants` says: on the terminal and as JSON.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "process/plan/comparison_forecast.h"

namespace diefill::app {

/// A table of the variants, what they take together on `threads` threads, then where the figures come from.
void print_comparison_plan(const std::string& title, const process::plan::ComparisonForecast& comparison,
                           int threads);

/// The same in SI units.
nlohmann::ordered_json comparison_plan_as_json(const std::string& title,
                                               const process::plan::ComparisonForecast& comparison);

}  // namespace diefill::app
