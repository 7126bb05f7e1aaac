// What a design of experiments over the parameters of lactose (Kottlan 2018, Tables 8, 17 and 18) says about
// any numbers that its beds have: extremes, effects of its factors, errors of the regression.
#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "process/laboratory/published/lactose/lactose_designs.h"
#include "process/laboratory/published/scene_experiment.h"

namespace diefill::process::laboratory {

/// Of the bed of one run of the design, in the unit of the published figures.
using DesignMetric = std::function<double(const SeedResults&, std::size_t bed)>;

struct NamedMetric {
  std::string name;  ///< as ids of published figures have it
  std::string unit;
  DesignMetric value;
};

struct DesignStudy {
  std::vector<DesignRun> design;
  std::vector<std::string> runs;  ///< names of all scenes of all beds
  std::vector<NamedMetric> metrics;
};

/// Effects on a metric, in the order of Factor.
using Effects = std::array<double, kFactors>;

std::vector<double> values_of(const DesignStudy& study, const SeedResults& seed, const DesignMetric& metric);
Effects effects_of(const DesignStudy& study, const SeedResults& seed, const DesignMetric& metric);

/// One of them.
double of(const Effects& all, Factor factor);
/// The largest size of an effect but for these factors'.
double largest_other(const Effects& all, const std::vector<Factor>& but);

using SignedFactor = std::pair<Factor, int>;  ///< and the published sign of its effect
/// Share of factors whose effect has the published sign; NaN where an effect is not known.
double agreeing(const Effects& all, const std::vector<SignedFactor>& signs);

/// A quantity that takes all runs.
LabQuantity study_quantity(const DesignStudy& study, const std::string& id,
                           const std::function<double(const SeedResults&)>& value);

/// Least and largest value of each metric: "<powder>-range-min-<metric>".
void add_ranges(LabPlan& plan, const DesignStudy& study, const std::string& powder);
/// A chart of each metric over the runs of the design, once all are finished; with the published least and
/// largest values where `powder` names them as in add_ranges(), read from `figures`. Empty: none.
LabCharts study_charts(const DesignStudy& study, const std::filesystem::path& figures,
                       const std::string& powder = "");
/// Mean errors of the regression with main effects, and with pairs: "ERR-<table>-with-<metric>".
void add_errors(LabPlan& plan, const DesignStudy& study, const std::string& table);

}  // namespace diefill::process::laboratory
