#include "render/report/viewer/shown_grains.h"

#include <QLocale>
#include <algorithm>
#include <numeric>

namespace diefill::render::report {
namespace {

struct Candidate {
  std::uint64_t id = 0;
  std::uint8_t kind = 0, in_cavity = 0;
};

void add(std::vector<Candidate>& all, const std::vector<std::uint64_t>& ids,
         const std::vector<std::uint8_t>& kinds) {
  for (std::size_t k = 0; k < ids.size(); ++k)
    all.push_back({ids[k], kinds.empty() ? std::uint8_t{0} : kinds[k]});
}

/// All grains there ever were at these instants, once each, by identity.
std::vector<Candidate> candidates(const results::FillResult& result,
                                  const std::vector<std::size_t>& instants) {
  std::vector<Candidate> all;
  const auto& inside = result.solid_fraction.in_cavity;
  for (std::size_t k = 0; k < result.powder.id.size(); ++k)
    all.push_back({result.powder.id[k],
                   result.powder.monodisperse() ? std::uint8_t{0} : result.powder.kind[k],
                   inside.size() > k ? inside[k] : std::uint8_t{0}});
  for (const std::size_t n : instants) add(all, result.instants[n].id, result.instants[n].kind);
  // The end stands before the instants, and it alone knows who is in the cavity.
  std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.id < b.id; });
  all.erase(std::unique(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.id == b.id; }),
            all.end());
  return all;
}

std::size_t spheres_of(const results::PowderState& powder, const Candidate& grain) {
  return powder.kinds.spheres.empty() ? powder.sphere_offsets.size() : powder.kinds.spheres[grain.kind];
}

/// Spread evenly over the numbers, and the same on every machine.
std::uint64_t scattered(std::uint64_t id) {
  return id * 0x9E3779B97F4A7C15U;
}

std::string with_commas(std::size_t number) {
  return QLocale(QLocale::English).toString(static_cast<qulonglong>(number)).toStdString();
}

/// Takes grains away until at most `most` spheres are left; returns those of all.
std::size_t thin(std::vector<Candidate>& grains, const results::PowderState& powder, std::size_t most) {
  const auto add_spheres = [&](std::size_t sum, const Candidate& grain) {
    return sum + spheres_of(powder, grain);
  };
  const std::size_t all = std::accumulate(grains.begin(), grains.end(), std::size_t{0}, add_spheres);
  if (all <= most) return all;
  std::sort(grains.begin(), grains.end(), [](const auto& a, const auto& b) {
    return a.in_cavity != b.in_cavity ? a.in_cavity > b.in_cavity : scattered(a.id) < scattered(b.id);
  });
  std::size_t kept = 0, spheres = 0;
  while (kept < grains.size() && spheres + spheres_of(powder, grains[kept]) <= most)
    spheres += spheres_of(powder, grains[kept++]);
  grains.resize(kept);
  std::sort(grains.begin(), grains.end(), [](const auto& a, const auto& b) { return a.id < b.id; });
  return all;
}

}  // namespace

ShownGrains shown_grains(const results::FillResult& result, const std::vector<std::size_t>& instants,
                         std::size_t most) {
  auto grains = candidates(result, instants);
  const auto in_cavity = [&] {
    return std::count_if(grains.begin(), grains.end(),
                         [](const auto& grain) { return grain.in_cavity == 1; });
  };
  const auto inside = in_cavity();
  const std::size_t all = thin(grains, result.powder, most);
  ShownGrains shown;
  for (const auto& grain : grains) {
    shown.id.push_back(grain.id);
    shown.kind.push_back(grain.kind);
    shown.in_cavity.push_back(grain.in_cavity);
    shown.spheres += spheres_of(result.powder, grain);
  }
  if (shown.spheres < all)
    shown.remark = with_commas(shown.spheres) + " of " + with_commas(all) + " spheres are shown, " +
                   (in_cavity() == inside ? "all those in the cavity at the end among them."
                                          : "an even part of those in the cavity at the end.");
  return shown;
}

}  // namespace diefill::render::report
