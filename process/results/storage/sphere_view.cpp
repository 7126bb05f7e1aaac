#include "process/results/storage/sphere_view.h"

#include <limits>

namespace diefill::results {

SphereView view_spheres(const FillResult& result) {
  const PowderState& powder = result.powder;
  const GrainSolidFraction& fraction = result.solid_fraction;
  SphereView view;
  if (powder.orientation.size() != powder.position.size()) return view;
  view.centre = powder.sphere_centres();
  view.radius = powder.radii_of_spheres();
  for (std::size_t k = 0; k < powder.position.size(); ++k) {
    const bool closed =
        k < fraction.solid_fraction.size() && k < fraction.open.size() && fraction.open[k] == 0;
    const double value = closed ? fraction.solid_fraction[k] : std::numeric_limits<double>::quiet_NaN();
    const std::uint64_t grain = k < powder.id.size() ? powder.id[k] : k;
    view.solid_fraction.insert(view.solid_fraction.end(), powder.spheres_of(k), value);
    view.grain.insert(view.grain.end(), powder.spheres_of(k), grain);
  }
  return view;
}

}  // namespace diefill::results
