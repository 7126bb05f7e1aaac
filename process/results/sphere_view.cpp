#include "process/results/sphere_view.h"

#include <limits>

namespace diefill::results {

SphereView view_spheres(const FillResult& result) {
  const PowderState& powder = result.powder;
  const GrainSolidFraction& fraction = result.solid_fraction;
  SphereView view;
  if (powder.orientation.size() != powder.position.size()) return view;
  view.centre = powder.sphere_centres();
  view.radius.reserve(view.centre.size());
  for (std::size_t k = 0; k < powder.position.size(); ++k) {
    const bool closed =
        k < fraction.solid_fraction.size() && k < fraction.open.size() && fraction.open[k] == 0;
    const double value = closed ? fraction.solid_fraction[k] : std::numeric_limits<double>::quiet_NaN();
    const std::uint64_t grain = k < powder.id.size() ? powder.id[k] : k;
    view.solid_fraction.insert(view.solid_fraction.end(), powder.sphere_offsets.size(), value);
    for (std::size_t s = 0; s < powder.sphere_offsets.size(); ++s)
      view.radius.push_back(powder.radius_of_sphere(k * powder.sphere_offsets.size() + s));
    view.grain.insert(view.grain.end(), powder.sphere_offsets.size(), grain);
  }
  return view;
}

}  // namespace diefill::results
