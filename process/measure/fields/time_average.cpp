#include "process/measure/fields/time_average.h"

#include <cstdio>
#include <stdexcept>

#include "process/measure/earlier_instant.h"

namespace diefill::process {
namespace {

std::vector<double> instants_between(const results::FillResult& result, double from, double to) {
  std::vector<double> times;
  for (const auto& instant : result.instants)
    if (instant.time >= from && instant.time <= to) times.push_back(instant.time);
  if (result.powder.time >= from && result.powder.time <= to) times.push_back(result.powder.time);
  return times;
}

void refuse(const results::FillResult& result, std::size_t found, double from, double to) {
  if (result.instants.empty())
    throw std::invalid_argument(
        "an average over time needs at least two instants, the results contain the end only; give "
        "measure.snapshot_interval in the scene and run it again");
  char text[280];
  std::snprintf(
      text, sizeof text,
      "an average over time needs at least two instants; from %.4g s to %.4g s the results contain %zu of "
      "%zu and the end at %.4g s (measure.snapshot_interval in the scene sets how many are stored)",
      from, to, found, result.instants.size(), result.powder.time);
  throw std::invalid_argument(text);
}

template <class Value>
void append(std::vector<Value>& all, const std::vector<Value>& more) {
  all.insert(all.end(), more.begin(), more.end());
}

/// Adds the grains of `one` to those of `all`.
void pool(results::FillResult& all, const results::FillResult& one) {
  append(all.powder.id, one.powder.id);
  append(all.powder.kind, one.powder.kind);
  append(all.powder.position, one.powder.position);
  append(all.powder.orientation, one.powder.orientation);
  append(all.powder.velocity, one.powder.velocity);
  append(all.solid_fraction.cell_volume, one.solid_fraction.cell_volume);
  append(all.solid_fraction.solid_fraction, one.solid_fraction.solid_fraction);
  append(all.solid_fraction.open, one.solid_fraction.open);
  append(all.solid_fraction.in_cavity, one.solid_fraction.in_cavity);
}

}  // namespace

results::FillResult time_average(const results::FillResult& result, double from, double to,
                                 std::size_t* instants) {
  const std::vector<double> times = instants_between(result, from, to);
  if (times.size() < 2) refuse(result, times.size(), from, to);
  if (instants) *instants = times.size();
  results::FillResult average = result_at(result, times.back());
  for (auto* grains : {&average.contact_stress.normal, &average.contact_stress.shear}) grains->clear();
  average.powder.angular_velocity.clear();
  average.figures.clear();
  average.maps.clear();
  average.sections.clear();
  average.profiles.clear();
  for (std::size_t n = 0; n + 1 < times.size(); ++n) pool(average, result_at(result, times[n]));
  return average;
}

}  // namespace diefill::process
