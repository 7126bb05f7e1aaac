#include "process/estimate/powder_discharge.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "process/input/scene_error.h"
#include "process/input/text_file.h"
#include "process/input/units.h"
#include "process/scene/powder_presets.h"

namespace diefill::process::estimate {

namespace {

/// m, of ASC100.29 (Bierwisch 2009, section 4.1.3: a box of 5 cm is about 500 grains wide).
constexpr double kRealGrain = 1e-4;
/// x of a slit of 10 mm at 0.1 m/s, the slowest and widest that was measured (Bierwisch 2009, section 4.1.1).
constexpr double kLongestMeasured = 2.9;

/// x of a slit of 10 mm after the 0.3 s that its outflow was recorded for (Bierwisch 2009, section 5.2.1).
constexpr double kLongestSimulated = 9;

bool one_of(const std::string& name, std::initializer_list<const char*> names) {
  return std::any_of(names.begin(), names.end(), [&](const char* known) { return name == known; });
}

/// Number under `key`; throws SceneError.
double number(const nlohmann::json& json, const char* key, const std::string& file) {
  if (!json.contains(key) || !json[key].is_number() || !std::isfinite(json[key].get<double>()))
    throw SceneError(file + ": found no number " + key +
                     "; give the fit.json that diefill fit-discharge --law 5.17 wrote");
  return json[key].get<double>();
}

}  // namespace

PowderDischarge discharge_of(const PowderSpec& powder) {
  PowderDischarge law;
  if (powder.model == GrainModel::D && powder.name != "ASC100.29 D1") {
    law.numbers = continuum::kSimulatedDischarge;
    law.longest = kLongestSimulated;
    law.grain_diameter = 6 * reference_sphere_radius(GrainModel::D);
    law.source = "hopper of model D grains, friction 0.5, no cohesion (Bierwisch 2009, Table 5.2)";
    law.applies = "grains of the same shape; more friction and cohesion let less run in";
    if (powder.name == "Distaloy AE") law.applies = "compared with this powder (process/estimate/README.md)";
    return law;
  }
  law.numbers = continuum::kMeasuredDischarge;
  law.longest = kLongestMeasured;
  law.grain_diameter = kRealGrain;
  law.source = "discharge of ASC100.29 through a slit of 6 mm (Bierwisch 2009, Table 4.1)";
  if (one_of(powder.name, {"ASC100.29 A1", "ASC100.29 B1", "ASC100.29 C1", "ASC100.29 D1"}))
    law.applies = "this model powder was fitted to that discharge";
  else if (powder.name.starts_with("ASC100.29"))
    law.applies = "the same powder; this model of it was not fitted to its discharge and runs faster";
  else
    law.applies = "another powder: measure yours and use diefill fit-discharge";
  return law;
}

PowderDischarge read_discharge(const std::filesystem::path& file) {
  nlohmann::json json;
  try {
    constexpr std::size_t kLargest = 1U << 20U;
    json = nlohmann::json::parse(load_text_file(file, {"fit", "but a fit is a short JSON text", kLargest}));
  } catch (const nlohmann::json::exception&) {
    throw SceneError(file.string() +
                     ": found no JSON; give the fit.json that diefill fit-discharge --law 5.17 wrote");
  } catch (const std::runtime_error& reason) {
    throw SceneError(file.string() + ": " + reason.what());
  }
  const std::string name = file.string();
  const bool named = json.is_object() && json.contains("law") && json["law"].is_string();
  const std::string fitted_law = named ? json["law"].get<std::string>() : "";
  if (!named || !json.contains("coefficients") || !json["coefficients"].is_object() ||
      (fitted_law != "5.17" && fitted_law != "transient"))
    throw SceneError(name +
                     ": found no fit of law 5.17 or transient; give the fit.json that diefill "
                     "fit-discharge --law 5.17 wrote");
  const auto& fitted = json["coefficients"];
  const auto value = [&](const char* key) {
    if (!fitted.contains(key) || !fitted[key].is_object())
      throw SceneError(name + ": found no coefficient " + key);
    return number(fitted[key], "value", name);
  };
  PowderDischarge law;
  law.numbers = {value("C_B"), value("C_I"), value("C_F"), value("beta")};
  law.longest =
      json.contains("largest_x") ? number(json, "largest_x", name) : std::numeric_limits<double>::infinity();
  if (law.longest < 0)
    throw SceneError(name + ": found largest_x = " + number_text(law.longest) +
                     ", allowed: 0 or more, as the flow begins there; fit again");
  law.grain_diameter = 0;  // openings as they are, or as grains felt them: either way those of no grain
  if (!(law.numbers.steady > 0 && law.numbers.beta > 0))
    throw SceneError(name + ": found C_F or beta of 0 or below, allowed: above 0; fit again");
  law.source = "fit " + name;
  law.applies = "measured on the powder in question";
  return law;
}

double discharged_share(const PowderDischarge& law, double x) {
  if (x < 0) return 0;
  if (x <= law.longest) return continuum::discharged_share(law.numbers, x);
  return continuum::discharged_share(law.numbers, law.longest) +
         continuum::rate_share(law.numbers, law.longest) * (x - law.longest);
}

}  // namespace diefill::process::estimate
