#include "process/laboratory/published/sawing/sawing_json.h"

#include <limits>

#include "process/results/json_numbers.h"

namespace diefill::process::laboratory::sawing {
namespace {

using Json = nlohmann::ordered_json;
using results::json_number;
using results::json_numbers;

/// Raised when runs of the same settings give other figures.
constexpr int kMethod = 2;

double number(const Json& json) {
  return json.is_null() ? std::numeric_limits<double>::quiet_NaN() : json.get<double>();
}

std::vector<double> numbers(const Json& json) {
  std::vector<double> all;
  for (const Json& one : json) all.push_back(number(one));
  return all;
}

/// A list of values as one list a member.
template <class Value>
Json columns(const std::vector<Value>& values,
             std::initializer_list<std::pair<const char*, double Value::*>> members) {
  Json json;
  for (const auto& [name, member] : members) {
    json[name] = Json::array();
    for (const Value& value : values) json[name].push_back(json_number(value.*member));
  }
  return json;
}

template <class Value>
std::vector<Value> rows(const Json& json,
                        std::initializer_list<std::pair<const char*, double Value::*>> members) {
  std::vector<Value> values(json.at(members.begin()->first).size());
  for (const auto& [name, member] : members)
    for (std::size_t k = 0; k < values.size(); ++k) values[k].*member = number(json.at(name).at(k));
  return values;
}

using GapMembers = std::initializer_list<std::pair<const char*, double GapSpeed::*>>;
using StressMembers = std::initializer_list<std::pair<const char*, double GrooveStress::*>>;
using GrainMembers = std::initializer_list<std::pair<const char*, double GrainStress::*>>;

constexpr GapMembers kGap = {{"radius", &GapSpeed::radius}, {"speed", &GapSpeed::speed}};
constexpr StressMembers kStress = {
    {"place", &GrooveStress::place}, {"width", &GrooveStress::width}, {"stress", &GrooveStress::stress}};
constexpr GrainMembers kGrains = {{"size", &GrainStress::size},
                                  {"low", &GrainStress::low},
                                  {"middle", &GrainStress::middle},
                                  {"high", &GrainStress::high}};

constexpr const char* kParts[] = {"fluid", "grain", "tool"};

Json section_json(const std::vector<SectionPoint>& section) {
  Json json;
  for (const char* part : kParts) json[part] = {{"x", Json::array()}, {"z", Json::array()}};
  for (const SectionPoint& point : section) {
    Json& part = json[kParts[static_cast<int>(point.part)]];
    part["x"].push_back(json_number(point.x));
    part["z"].push_back(json_number(point.z));
  }
  return json;
}

std::vector<SectionPoint> section_of(const Json& json) {
  std::vector<SectionPoint> section;
  for (int part = 0; part < 3; ++part) {
    const Json& points = json.at(kParts[part]);
    for (std::size_t k = 0; k < points.at("x").size(); ++k)
      section.push_back(
          {static_cast<SectionPoint::Part>(part), number(points["x"][k]), number(points["z"][k])});
  }
  return section;
}

}  // namespace

Json fluid_settings(const engine::FluidSettings& fluid) {
  const engine::laws::DpdParameters& law = fluid.law;
  return {{"method", kMethod},
          {"density", law.density},
          {"repulsion", law.repulsion},
          {"noise", law.noise},
          {"thermal_energy", law.thermal_energy},
          {"grain_stiffness", law.grain_stiffness},
          {"tool_stiffness", law.tool_stiffness},
          {"tool_damping", law.tool_damping},
          {"solid_share", law.solid_share},
          {"grip", law.grip},
          {"spacing", kSpacing},
          {"grain_density", kGrainDensity},
          {"time_step", fluid.time_step}};
}

std::string text_of(const ShearedFigures& figures) {
  const Json json = {
      {"viscosity", json_number(figures.viscosity)}, {"temperature", json_number(figures.temperature)},
      {"pressure", json_number(figures.pressure)},   {"scatter", json_number(figures.scatter)},
      {"solids", json_number(figures.solids)},       {"particles", json_number(figures.particles)}};
  return json.dump();
}

ShearedFigures sheared_figures(const std::string& text) {
  const Json json = Json::parse(text);
  return {number(json.at("viscosity")), number(json.at("temperature")), number(json.at("pressure")),
          number(json.at("scatter")),   number(json.at("solids")),      number(json.at("particles"))};
}

std::string text_of(const GrooveFigures& figures) {
  const Json json = {{"gap", columns(figures.gap, kGap)},
                     {"stress", columns(figures.stress, kStress)},
                     {"grains", columns(figures.grains, kGrains)},
                     {"section", section_json(figures.section)},
                     {"time", json_numbers(figures.time)},
                     {"distance", json_numbers(figures.distance)},
                     {"mean_distance", json_number(figures.mean_distance)},
                     {"solids", json_number(figures.solids)},
                     {"temperature", json_number(figures.temperature)},
                     {"particle_steps", json_number(figures.particle_steps)}};
  return json.dump();
}

GrooveFigures groove_figures(const std::string& text) {
  const Json json = Json::parse(text);
  GrooveFigures figures;
  figures.gap = rows(json.at("gap"), kGap);
  figures.stress = rows(json.at("stress"), kStress);
  figures.grains = rows(json.at("grains"), kGrains);
  figures.section = section_of(json.at("section"));
  figures.time = numbers(json.at("time"));
  figures.distance = numbers(json.at("distance"));
  figures.mean_distance = number(json.at("mean_distance"));
  figures.solids = number(json.at("solids"));
  figures.temperature = number(json.at("temperature"));
  figures.particle_steps = number(json.at("particle_steps"));
  return figures;
}

}  // namespace diefill::process::laboratory::sawing
