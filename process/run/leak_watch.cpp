#include "process/run/leak_watch.h"

#include <cstdio>
#include <limits>

#include "process/tooling/half_model.h"

namespace diefill::process {

namespace {

/// Share of the powder up to which grains beneath the cavity are ignored as strays.
constexpr double kStrays = 1e-3;

/// Beneath the cavities, a grain diameter wider, as what falls out drifts.
geometry::Box below_cavities(const Tooling& tooling, double grain_diameter) {
  if (!tooling.cavity.found) return {};
  geometry::Box below = tooling.all_cavities().box;
  below.lower.head<2>().array() -= grain_diameter;
  below.upper.head<2>().array() += grain_diameter;
  below.upper[2] = below.lower[2];
  below.lower[2] = -std::numeric_limits<double>::max();
  return below;
}

}  // namespace

LeakWatch::LeakWatch(const Tooling& tooling, double grain_diameter)
    : tooling_(tooling), below_(below_cavities(tooling, grain_diameter)) {}

void LeakWatch::count_removed(const Eigen::Vector3d& place) {
  if (below_.contains(place)) ++state_.grains;
}

std::optional<std::string> LeakWatch::warning(std::uint64_t poured) const {
  if (static_cast<double>(state_.grains) <= kStrays * static_cast<double>(poured)) return std::nullopt;
  char text[240];
  std::snprintf(text, sizeof text,
                "%.0f of %.0f grains leaked out below the cavity: unless this is intended, the moving tools "
                "leave an opening there (for example a punch too short for its travel)",
                copies(tooling_) * static_cast<double>(state_.grains),
                copies(tooling_) * static_cast<double>(poured));
  return text;
}

std::optional<std::string> LeakWatch::first_warning(std::uint64_t poured) {
  if (state_.warned) return std::nullopt;
  auto warning = this->warning(poured);
  state_.warned = warning.has_value();
  return warning;
}

}  // namespace diefill::process
