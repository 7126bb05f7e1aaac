// What `diefill compare` will take: every variant of a scene, less what an earlier one has computed for it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "process/plan/forecast.h"
#include "process/plan/pilot.h"
#include "process/plan/plan.h"
#include "process/scene/variants.h"

namespace diefill::process::plan {

/// One variant, with one seed.
struct VariantForecast {
  std::string name;
  Forecast forecast;  ///< of the whole, as if it ran alone
  double shared_seconds =
      0;  ///< simulated s at its beginning that an earlier variant leaves (run/restart/shared_start.h)
  std::optional<double> wall_seconds;  ///< s of computing the rest; nothing without a pilot
};

/// A pilot run and what it is for: grains of one size under one law.
struct PowderPilot {
  std::string powder;
  std::vector<std::string> laws;  ///< terms in use
  Pilot pilot;
};

struct ComparisonForecast {
  std::vector<VariantForecast> variants;  ///< in their order
  std::vector<PowderPilot>
      pilots;  ///< one for each powder, grain size and law, of the first variant with them
  std::optional<double> wall_seconds;  ///< s, of all, one after the other
};

/// Builds every variant's tools, gives them to options.tools_ready, and runs a pilot for each powder and law
/// among them. Throws as a run would.
ComparisonForecast forecast_comparison(const std::vector<Variant>& variants, const PlanOptions& options);

/// s of wall-clock time that the forecast has for what comes after the first `seconds` of simulated time;
/// nothing where it has no time.
std::optional<double> wall_seconds_after(const Forecast& forecast, double seconds);

}  // namespace diefill::process::plan
