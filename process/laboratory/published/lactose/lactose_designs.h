// Designs of Kottlan 2018 (Tables 8, 17 and 18), and the effect of each of their factors on a quantity.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "process/laboratory/published/lactose/adhesive_bed.h"

namespace diefill::process::laboratory {

/// Factors, in the order of the columns of lactose_designs.csv.
enum class Factor {
  hamaker,
  radius,
  friction,
  dynamic_ratio,
  young,
  unloading_ratio,
  cohesion_ratio,
  tangential_ratio,
  restitution,
  damping_ratio,
  depth,
  rolling
};
inline constexpr std::size_t kFactors = 12;
/// In the folder of scenes.
inline constexpr const char* kLactoseDesigns = "lactose_designs.csv";

struct DesignRun {
  AdhesivePowder powder;
  std::vector<int>
      levels;  ///< of each factor: 1 high, -1 low, 0 centre; all 0 for a factor that is not varied
};

/// The runs of one table, the centre last. Throws SceneError, naming the line, where the file is missing or
/// wrong, or has no such table.
std::vector<DesignRun> design_runs(const std::filesystem::path& file, const std::string& table);

/// Mean of the runs with the factor high less that of those with it low.
double effect_of(const std::vector<DesignRun>& runs, const std::vector<double>& values, Factor factor);

/// Mean over runs of |predicted - value| / |value| in percent (Tables 9, 19 and 20), by least squares over
/// the corners: with the main effects, or also with one term for each distinct string of pairs.
double regression_error(const std::vector<DesignRun>& runs, const std::vector<double>& values,
                        bool with_pairs);

}  // namespace diefill::process::laboratory
