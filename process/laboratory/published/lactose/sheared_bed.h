// A shear test of adhesive powder under a vaned head (Kottlan 2018, section 2.7.4): pre-shear at 3 kPa until
// the torque is steady, free of torque, unloaded, sheared again; one run for each normal stress, all from the
// same pre-sheared bed. Its runs, and what is read off their results.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "process/continuum/yield_locus.h"
#include "process/laboratory/published/lactose/shear_cell.h"

namespace diefill::process::laboratory {

inline constexpr double kPreshearStress = 3e3;  ///< Pa

struct ShearTest {
  std::string name;  ///< its runs are called "<name>, <stress> kPa"
  FilledCell filled;
  std::vector<double> stresses;  ///< Pa, normal, of the shears
  double longest = 20;           ///< d at the rim, of a pre-shear that does not become steady
  double sheared = 4;            ///< d at the rim, of a shear

  std::string run_name(double stress) const;
  std::vector<std::string> run_names() const;
};

/// A run of shear_tester.toml.
LabRun run_of(const ShearTest& test, double stress);

/// Of all stresses of tests with equally many: those of the first stress, then those of the second, ... .
/// Runs that are computed at the same time are of different beds, so that no pre-shear is computed twice.
std::vector<LabRun> runs_of(const std::vector<ShearTest>& tests);

/// When the head pre-sheared and sheared; nothing where it has not done all its motions.
struct ShearSpans {
  Span preshear, shear;
};
std::optional<ShearSpans> shear_spans(const SeedResults& seed, const ShearTest& test, double stress);

/// Of the head of one run.
ShearCurve head_curve(const SeedResults& seed, const ShearTest& test, double stress);

/// Steady stresses, Pa: means over the last 6 d of the pre-shear. NaN where there are none.
continuum::StressPoint preshear_of(const SeedResults& seed, const ShearTest& test);
/// Stresses at failure, Pa, of those shears that have results.
std::vector<continuum::StressPoint> strengths_of(const SeedResults& seed, const ShearTest& test);
/// Of these.
continuum::YieldLocus locus_of(const SeedResults& seed, const ShearTest& test);
/// Solid fraction of the pre-sheared bed from a grain diameter over the floor's vanes to one under those of
/// the head.
double fraction_of(const SeedResults& seed, const ShearTest& test);

}  // namespace diefill::process::laboratory
