// The contents of every cavity of a die, by mass: one row per cavity.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "process/results/fill_result.h"

namespace diefill::results {

/// Figures of one cavity; NaN: not known.
struct CavityRow {
  int number = 1;             ///< 1 is the largest, which figures without a number are of
  Eigen::Vector2d place;      ///< m, of its middle, seen from above
  double volume = 0;          ///< m^3
  double mass = 0;            ///< kg, of the real powder in it
  bool estimate = false;      ///< the mass follows from an estimate, not from a weighed apparent density
  double full_mass = 0;       ///< kg, that it holds where full at apparent density
  double fill_ratio = 0;      ///< mass over full mass
  double fill_height = 0;     ///< m, mean height of the powder surface above the floor
  double depth = 0;           ///< m, from the floor to the fill plane
  double solid_fraction = 0;  ///< mean solid fraction of the powder in it
  double std = 0;             ///< of the solid fraction over single grains
  std::uint64_t grains = 0;   ///< that the mean stands on
  std::string verdict;        ///< in one line
};

/// A row for each cavity; none where the tools enclose no cavity.
std::vector<CavityRow> cavity_rows(const FillResult& result);

/// Name in front of the figures of cavity `number` in report.json: "" or "cavity_2_".
std::string figure_prefix(int number);

/// Topic under which results keep the verdicts, and the name of that of cavity `number` in it.
inline constexpr const char* kVerdictTopic = "verdict";
std::string verdict_name(int number);

/// Quantity of a profile of cavity `number`: "fill level", "fill level, cavity 2".
std::string quantity_in_cavity(const std::string& quantity, int number);
/// The two apart again: {"fill level", 2}; the number is 1 where none is named.
std::pair<std::string, int> quantity_and_cavity(const std::string& quantity);

/// "3.12 g", or "about 3.1 g" for an estimate.
std::string mass_of(const CavityRow& row);

}  // namespace diefill::results
