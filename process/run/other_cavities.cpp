#include "process/run/other_cavities.h"

#include <cstdio>

#include "process/measure/cavity_position.h"
#include "process/measure/measure.h"
#include "process/run/die_frame.h"

namespace diefill::process {

void add_other_cavities(results::FillResult& result, const std::vector<geometry::Cavity>& others) {
  results::GrainSolidFraction fraction = result.solid_fraction;
  std::string warning;
  for (std::size_t n = 0; n < others.size(); ++n) {
    results::CavityState cavity = cavity_state(others[n]);
    cavity.azimuth_zero = result.cavity.azimuth_zero;
    fraction.in_cavity = grains_in_cavity(cavity, result.powder);
    const auto summary = summarise(result.powder, fraction, cavity);
    const double mass = filled_mass(result.powder, fraction);
    const std::string number = std::to_string(n + 2), name = "cavity_" + number;
    result.figures[name + "_volume_m3"] = cavity.volume;
    result.figures[name + "_filled_mass_kg"] = mass;
    result.figures[name + "_solid_fraction"] = summary.mean;
    result.figures[name + "_solid_fraction_std"] = summary.std;
    const Eigen::Vector3d place = 1e3 * cavity.axis_origin;
    char text[200];
    std::snprintf(text, sizeof text,
                  "; cavity %s at (%.1f, %.1f) mm, %.4g cm3, holds %.4g g, mean solid fraction %.3f",
                  number.c_str(), place.x(), place.y(), 1e6 * cavity.volume, 1e3 * mass, summary.mean);
    warning += text;
    result.other_cavities.push_back(std::move(cavity));
  }
  if (others.empty()) return;
  result.warnings.push_back("the tools have " + std::to_string(others.size() + 1) +
                            " cavities: figures and maps are of the largest (diefill map --cavity draws the "
                            "others)" +
                            warning);
}

}  // namespace diefill::process
