#include "process/measure/figures/zone.h"

#include <cctype>

#include "process/measure/cavity_position.h"
#include "process/measure/figures/enough_grains.h"
#include "process/results/no_value.h"

namespace diefill::process {
namespace {

std::string key_of(const std::string& name) {
  std::string key;
  for (const char letter : name) key += std::isalnum(static_cast<unsigned char>(letter)) != 0 ? letter : '_';
  return key;
}

/// Mass and volumes of the powder of one zone.
struct Contents {
  double mass = 0, solid_volume = 0, cell_volume = 0;
  std::size_t closed_cells = 0;
};

/// Whether a grain lies in one of the cavities; of tools without any, all grains count.
bool counts(const results::FillResult& result, std::size_t k) {
  return result.cavity.volume <= 0 || result.solid_fraction.in_cavity[k] != 0 ||
         lies_in_any_cavity(result.other_cavities, result.powder.position[k]);
}

Contents contents_of(const results::FillResult& result, const Zone& zone) {
  const auto& powder = result.powder;
  const auto& cells = result.solid_fraction;
  Contents contents;
  for (std::size_t k = 0; k < powder.position.size(); ++k) {
    if (!counts(result, k)) continue;
    if (!zone.contains(powder.position[k])) continue;
    contents.mass += powder.mass_of(k);
    if (cells.open[k] != 0) continue;
    contents.solid_volume += powder.solid_volume_of(k);
    contents.cell_volume += cells.cell_volume[k];
    ++contents.closed_cells;
  }
  return contents;
}

}  // namespace

bool Zone::contains(const Eigen::Vector3d& point) const {
  for (int k = 0; k < 3; ++k)
    if (point[k] < lower[k] || point[k] > upper[k]) return false;
  const double radius = (point.head<2>() - axis).norm();
  return radius >= inner_radius && radius <= outer_radius;
}

void add_zone_figures(results::FillResult& result, const std::vector<Zone>& zones) {
  const double all = contents_of(result, Zone()).mass;
  for (const Zone& zone : zones) {
    const Contents contents = contents_of(result, zone);
    result.figures[zone_mass_figure(zone.name)] = contents.mass;
    if (all > 0) result.figures[zone_share_figure(zone.name)] = contents.mass / all;
    const std::string fraction = zone_solid_fraction_figure(zone.name);
    if (contents.closed_cells >= kMinGrains)
      result.figures[fraction] = contents.solid_volume / contents.cell_volume;
    else
      results::set_no_value(
          result, fraction,
          too_few_text(contents.closed_cells, "below the surface in zone \"" + zone.name + '"', kMinGrains));
  }
}

std::string zone_mass_figure(const std::string& zone) {
  return "filled_mass_in_" + key_of(zone) + "_kg";
}

std::string zone_share_figure(const std::string& zone) {
  return "mass_share_in_" + key_of(zone);
}

std::string zone_solid_fraction_figure(const std::string& zone) {
  return "solid_fraction_in_" + key_of(zone);
}

}  // namespace diefill::process
