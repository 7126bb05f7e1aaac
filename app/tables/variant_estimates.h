// Estimates of a scene's variants side by side: how full, how fast, how often.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "process/estimate/estimate.h"

namespace diefill::app {

/// The estimate of one variant.
struct VariantEstimate {
  std::string name;
  process::estimate::Estimate estimate;
};

/// A line for each: share filled of its emptiest cavity, critical shoe speed, crossings, cycle time, answer.
void print_variant_estimates(const std::vector<VariantEstimate>& variants);

/// The line of one estimate, without the variant's name. SI units; null where there is no value.
nlohmann::ordered_json estimate_in_short_as_json(const process::estimate::Estimate& estimate);
/// The lines of all, each with its `name`.
nlohmann::ordered_json variant_estimates_as_json(const std::vector<VariantEstimate>& variants);

}  // namespace diefill::app
