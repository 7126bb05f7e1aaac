#include "process/tooling/examination/other_cavities.h"

#include <iterator>
#include <utility>

#include "process/measure/cavity_position.h"
#include "process/measure/figures/enough_grains.h"
#include "process/measure/measure.h"
#include "process/results/cavity_rows.h"
#include "process/results/no_value.h"
#include "process/tooling/die_frame.h"

namespace diefill::process {
namespace {

/// What a result has of its own cavity.
struct OfCavity {
  results::CavityState cavity;
  std::vector<std::uint8_t> in_cavity;
  results::SolidFractionSummary summary;
  std::map<std::string, double> figures;
  std::vector<results::Field2D> maps;
  std::vector<results::SectionField> sections;
  std::vector<results::Profile> profiles;
  std::vector<results::Topic> topics;
};

void exchange(results::FillResult& result, OfCavity& other) {
  std::swap(result.cavity, other.cavity);
  std::swap(result.solid_fraction.in_cavity, other.in_cavity);
  std::swap(result.summary, other.summary);
  std::swap(result.figures, other.figures);
  std::swap(result.maps, other.maps);
  std::swap(result.sections, other.sections);
  std::swap(result.profiles, other.profiles);
  std::swap(result.topics, other.topics);
}

void add_figures(results::FillResult& result, const OfCavity& measured, int number) {
  const std::string prefix = results::figure_prefix(number);
  for (const auto& [name, value] : measured.figures)
    if (!result.figures.contains(name) || !name.starts_with("apparent_density"))
      result.figures[prefix + name] = value;
  result.figures.erase(prefix + "shoe_speed_m_s");
  result.figures[prefix + "volume_m3"] = measured.cavity.volume;
  result.figures[prefix + "solid_fraction"] = measured.summary.mean;
  result.figures[prefix + "solid_fraction_std"] = measured.summary.std;
  result.figures[prefix + "solid_fraction_grains"] = static_cast<double>(measured.summary.grains);
}

void add_words(results::FillResult& result, const OfCavity& measured, int number) {
  for (const auto& topic : measured.topics)
    for (std::size_t n = 0; n < topic.name.size(); ++n)
      if (topic.topic == results::kVerdictTopic)
        results::add_statement(result, topic.topic, results::verdict_name(number), topic.text[n]);
      else
        results::add_statement(result, topic.topic, results::figure_prefix(number) + topic.name[n],
                               topic.text[n]);
}

/// Profiles only: maps are drawn again of whichever cavity is asked for.
void add_profiles(results::FillResult& result, OfCavity& measured, int number) {
  for (auto& profile : measured.profiles) {
    profile.quantity = results::quantity_in_cavity(profile.quantity, number);
    result.profiles.push_back(std::move(profile));
  }
}

}  // namespace

void add_other_cavities(results::FillResult& result, const std::vector<geometry::Cavity>& others,
                        const MeasureCavity& measure) {
  for (std::size_t n = 0; n < others.size(); ++n) {
    const int number = static_cast<int>(n) + 2;
    OfCavity other;
    other.cavity = cavity_state(others[n]);
    other.cavity.azimuth_zero = result.cavity.azimuth_zero;
    other.in_cavity = grains_in_cavity(other.cavity, result.powder);
    const auto speed = result.figures.find("shoe_speed_m_s");
    if (speed != result.figures.end()) other.figures.insert(*speed);
    exchange(result, other);
    result.summary = summarise(result.powder, result.solid_fraction, result.cavity);
    result.figures["filled_mass_kg"] = filled_mass(result.powder, result.solid_fraction);
    if (measure) measure(result);
    result.summary = reliable_summary(result.summary);
    exchange(result, other);
    add_figures(result, other, number);
    add_words(result, other, number);
    add_profiles(result, other, number);
    result.other_cavities.push_back(std::move(other.cavity));
  }
  if (!others.empty())
    result.warnings.push_back("the tools have " + std::to_string(others.size() + 1) +
                              " cavities: figures without a number and pictures refer to the largest; the "
                              "table lists all (diefill map --cavity draws the others)");
}

}  // namespace diefill::process
