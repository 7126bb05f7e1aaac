// Figures and charts of sawing from its runs.
#pragma once

#include <string>
#include <vector>

#include "process/laboratory/published/sawing/groove.h"
#include "process/laboratory/published/sawing/viscosity.h"
#include "process/measure/figures/line_fit.h"
#include "process/results/studies/experiment_result.h"

namespace diefill::process::laboratory::sawing {

/// Speed over the radius, through all of the gap but half a unit at either wall, where particles lie in
/// layers.
FittedLine line_through(const std::vector<GapSpeed>& gap);
/// The fluid's speed at a wall of this radius: of the profile between two cylinders, which is a line over the
/// logarithm of the radius, through the same places.
double speed_at(const std::vector<GapSpeed>& gap, double radius);

/// Share of the force on the ingot within 30 um of the groove's lowest line.
double share_at_centre(const GrooveFigures& figures);
/// Mean normal stress on the ingot beyond 100 um from that line.
double stress_at_sides(const GrooveFigures& figures);
/// Distance in the last tenth of the run less that before its last third: 0 once the wire keeps its height.
double late_change(const GrooveFigures& figures);
/// Grains of this size; throws std::out_of_range where there are none.
const GrainStress& grains_of(const GrooveFigures& figures, double size);

/// A run with the pressure (N/mm^2) of its process.
struct NamedGroove {
  std::string name;
  double pressure;
  GrooveFigures figures;
};

/// Viscosity over the shear rate.
struct ViscosityCurve {
  std::vector<double> rates;
  std::vector<ShearedFigures> figures;
};

results::ExperimentChart viscosity_chart(const ViscosityCurve& fluid, const ViscosityCurve& slurry);
results::ExperimentChart gap_chart(const std::vector<GapSpeed>& gap, double wire_speed);
results::ExperimentChart stress_chart(const std::vector<NamedGroove>& all);
/// View across the wire: particles of a slice.
results::ExperimentChart section_chart(const NamedGroove& one, std::size_t number);
results::ExperimentChart distance_chart(const std::vector<NamedGroove>& all);
/// Share of grains under more than 5 N/mm^2 over their size.
results::ExperimentChart grain_chart(const std::vector<NamedGroove>& all);

}  // namespace diefill::process::laboratory::sawing
