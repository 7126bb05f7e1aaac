// Fits that diefill fit-discharge wrote, as discharge laws of an estimate.
#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "process/continuum/discharge_fit.h"
#include "process/estimate/discharge/powder_discharge.h"
#include "process/input/scene_error.h"
#include "process/input/shown_value.h"
#include "process/input/text_file.h"
#include "process/input/units.h"
#include "process/powder/empty_annulus.h"

namespace diefill::process::estimate {

namespace {

constexpr const char* kOpeningGrain = "effective_opening_grain_diameter_m";

/// A fit.json: its law and its numbers. Throws SceneError for what is none.
class FitFile {
 public:
  explicit FitFile(const std::filesystem::path& file) : name_(file.string()) {
    try {
      constexpr std::size_t kLargest = 1U << 20U;
      json_ =
          nlohmann::json::parse(load_text_file(file, {"fit", "but a fit is a short JSON text", kLargest}));
    } catch (const nlohmann::json::exception&) {
      refuse("no JSON; give the fit.json that diefill fit-discharge wrote");
    } catch (const std::runtime_error& reason) {
      throw SceneError(name_ + ": " + reason.what());
    }
    const bool named = json_.is_object() && json_.contains("law") && json_["law"].is_string();
    if (!named || !json_.contains("coefficients") || !json_["coefficients"].is_object())
      refuse("no fit of a discharge law; give the fit.json that diefill fit-discharge wrote");
  }

  [[noreturn]] void refuse(const std::string& found) const { throw SceneError(name_ + ": found " + found); }
  const std::string& name() const { return name_; }
  std::string law() const { return json_["law"].get<std::string>(); }
  bool has(const char* key) const { return json_.contains(key); }
  double number(const char* key) const { return number_in(json_, key, key); }
  bool has_coefficient(const char* key) const { return json_["coefficients"].contains(key); }
  double coefficient(const char* key) const {
    const auto& fitted = json_["coefficients"];
    if (!fitted.contains(key) || !fitted[key].is_object()) refuse(std::string("no coefficient ") + key);
    return number_in(fitted[key], "value", key);
  }
  double coefficient_above_zero(const char* key) const {
    const double value = coefficient(key);
    if (!(value > 0)) refuse(key + (" = " + number_text(value)) + ", allowed: above 0; fit again");
    return value;
  }

  /// Lines that are no text are left out.
  std::vector<std::string> lines(const char* key) const {
    std::vector<std::string> lines;
    if (has(key) && json_[key].is_array())
      for (const auto& line : json_[key])
        if (line.is_string()) lines.push_back(one_line(line.get<std::string>()));
    return lines;
  }
  bool is_false(const char* key) const { return has(key) && json_[key] == false; }

 private:
  double number_in(const nlohmann::json& json, const char* key, const char* called) const {
    if (!json.contains(key) || !json[key].is_number() || !std::isfinite(json[key].get<double>()))
      refuse(std::string("no number ") + called + "; give the fit.json that diefill fit-discharge wrote");
    return json[key].get<double>();
  }

  std::string name_;
  nlohmann::json json_;
};

void read_transient(const FitFile& fit, PowderDischarge& law) {
  law.numbers = {fit.coefficient("C_B"), fit.coefficient("C_I"), fit.coefficient_above_zero("C_F"),
                 fit.coefficient_above_zero("beta")};
  law.longest = fit.has("largest_x") ? fit.number("largest_x") : std::numeric_limits<double>::infinity();
  if (law.longest < 0)
    fit.refuse("largest_x = " + number_text(law.longest) +
               ", allowed: 0 or more, as the flow begins there; fit again");
}

/// x = t sqrt(g/D) - 1/5 at which the laws of a moving shoe are held against each other, up to `longest`.
std::vector<double> compared_times(double longest) {
  constexpr int kTimes = 40;
  std::vector<double> times;
  for (int k = 0; k <= kTimes; ++k) times.push_back(longest * k / kTimes);
  return times;
}

/// C_S (x + 1/5)^(1 + n)
double share_of(const continuum::PowerLawCoefficients& power, double x) {
  return power.coefficient * std::pow(x + continuum::kBurst, 1 + power.exponent);
}

/// The transient law that comes nearest to the power law from x = 0 to `longest`.
continuum::TransientCoefficients transient_near(const continuum::PowerLawCoefficients& power,
                                                double longest) {
  continuum::DischargeData data;
  data.density = 1;
  for (const double x : compared_times(longest))
    data.points.push_back({.value = share_of(power, x),
                           .speed = std::sqrt(data.gravity) / (x + continuum::kBurst),
                           .width = 1,
                           .length = 1,
                           .shoe_length = 1});
  try {
    const auto found = continuum::fit_discharge(continuum::DischargeLaw::moving_shoe, data);
    return {found.number("C_B"), found.number("C_I"), found.number("C_F"), found.number("beta")};
  } catch (const std::invalid_argument&) {  // as for n = 0, where any beta does
    const double rate = (share_of(power, longest) - share_of(power, 0)) / longest;
    return {share_of(power, 0), rate, rate, 1};
  }
}

void read_power(const FitFile& fit, PowderDischarge& law) {
  constexpr double kMisfit = 0.05;  // of the mass; far below what an estimate is off by
  const continuum::PowerLawCoefficients power = {fit.coefficient_above_zero("C_S"), fit.coefficient("n")};
  law.longest = fit.number("largest_x");
  if (!(law.longest > 0))
    fit.refuse("largest_x = " + number_text(law.longest) +
               ", allowed: above 0 for law 5.18, as no flow was measured otherwise; measure at lower speeds");
  law.numbers = transient_near(power, law.longest);
  for (const double x : compared_times(law.longest))
    if (!(std::abs(continuum::discharged_share(law.numbers, x) / share_of(power, x) - 1) < kMisfit))
      fit.refuse("law 5.18 with n = " + number_text(power.exponent) +
                 ", a flow that comes to no steady rate, as the estimate needs it; fit the masses with "
                 "--law 5.17");
  law.applies += "; law 5.18 as the law 5.17 that is nearest to it";
}

/// Beverloo's law has the steady rate alone; how it comes about is taken from the published flow.
void read_slit_rates(const FitFile& fit, PowderDischarge& law) {
  const double steady = fit.coefficient_above_zero("C");
  law.numbers = continuum::kSimulatedDischarge;
  const double ratio = steady / law.numbers.steady;
  for (double* number : {&law.numbers.burst, &law.numbers.initial, &law.numbers.steady}) *number *= ratio;
  law.longest = std::numeric_limits<double>::infinity();
  law.applies +=
      " once the flow is steady; how it begins is in proportion to a hopper of model D grains (Bierwisch "
      "2009, "
      "Table 5.2)";
}

/// The fit's openings count as D - k d of the grains that it was measured with, or as they are.
void read_grains(const FitFile& fit, PowderDischarge& law) {
  const double grain = fit.has(kOpeningGrain) ? fit.number(kOpeningGrain) : 0;
  if (grain < 0)
    fit.refuse(std::string(kOpeningGrain) + " = " + number_text(grain) + ", allowed: 0 or more; fit again");
  const double annulus = fit.has_coefficient("k") ? fit.coefficient_above_zero("k") : kEmptyAnnulus;
  law.grain_diameter = grain * (1 - annulus / kEmptyAnnulus);
  if (grain == 0)
    law.remark = fit.name() +
                 " counts openings as they are, and the estimate takes 1.4 d of the scene's grains off them: "
                 "where the fit's data are of coarse grains, as from a simulation, that is taken off twice; "
                 "fit them again with --grain-diameter";
}

/// What fit-discharge said of the fit goes on to the estimate.
void add_remarks(const FitFile& fit, PowderDischarge& law) {
  for (const std::string& remark : fit.lines("remarks"))
    law.remark += (law.remark.empty() ? "" : "; ") + fit.name() + " says: " + remark;
  law.doubts = fit.lines("doubts");
  law.holds_beyond_longest = !fit.is_false("holds_beyond_largest_x");
}

}  // namespace

PowderDischarge read_discharge(const std::filesystem::path& file) {
  const FitFile fit(file);
  const std::string fitted = fit.law();
  PowderDischarge law;
  law.source = "fit " + fit.name();
  law.applies = "measured on the powder in question";
  if (fitted == "5.17" || fitted == "transient")
    read_transient(fit, law);
  else if (fitted == "5.18")
    read_power(fit, law);
  else if (fitted == "beverloo-slit")
    read_slit_rates(fit, law);
  else if (fitted == "beverloo-round")
    fit.refuse(
        "a fit of law beverloo-round, but the estimate goes by the flow through slits, which is another than "
        "through holes; fit rates through slits (beverloo-slit) or masses of a moving shoe (5.17)");
  else
    fit.refuse("a fit of law \"" + fitted + "\", allowed: 5.17, 5.18, transient, beverloo-slit");
  read_grains(fit, law);
  add_remarks(fit, law);
  return law;
}

}  // namespace diefill::process::estimate
