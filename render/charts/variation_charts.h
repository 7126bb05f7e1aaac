// Charts of how solid fraction varies: profiles with their scatter, histograms, fill levels; several runs in
// one.
#pragma once

#include "process/results/spread_profile.h"
#include "render/charts/chart.h"

namespace diefill::render {

/// A curve's data and the name it goes by in the legend; empty: none.
template <class Data>
struct Named {
  std::string name;
  Data data;
};

/// Profiles as lines in bands of one standard deviation to both sides. Over height, height runs along x;
/// `across` is what the mean is over there: the azimuth of a ring, the cross-section of any other cavity.
Chart spread_chart(const std::vector<Named<results::SpreadProfile>>& profiles, const std::string& title,
                   const std::string& subtitle, const std::string& across = "azimuth");

/// Shares of grains in percent: bars for one run, lines for several; means in the legend.
Chart histogram_chart(const std::vector<Named<results::Histogram>>& histograms, const std::string& title,
                      const std::string& subtitle);

/// Curves over azimuth or another coordinate, such as fill levels.
Chart profile_chart(const std::vector<Named<results::Profile>>& profiles, const std::string& title,
                    const std::string& subtitle);

/// Fill levels [mm] above the cavity's floor, with the fill plane as a reference; `depths` has its height
/// above that floor [mm] for each level. Cavities of different depths each have their own, with its name.
Chart fill_level_chart(const std::vector<Named<results::Profile>>& levels, const std::vector<double>& depths,
                       const std::string& subtitle);

}  // namespace diefill::render
