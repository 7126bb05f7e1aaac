// The hopper of Bierwisch 2009, section 5.1: local diffusion length over the solid fraction, kinematic models
// against DEM at six heights, scaling with the slit's width.
#include <cmath>
#include <cstdio>

#include "process/laboratory/flow/hopper_charts.h"
#include "process/laboratory/flow/hopper_contours.h"
#include "process/laboratory/flow/hopper_figures.h"
#include "process/laboratory/flow/hopper_setups.h"
#include "process/laboratory/flow/registry.h"

namespace diefill::process::laboratory {

namespace {

constexpr double kConstant = 1.8e-3;  // m, B of the incompressible model (Bierwisch 2009, section 5.1.2)

/// Table 5.1 (Bierwisch 2009) with grains enlarged by `factor`.
std::vector<HopperSetup> setups(double factor) {
  HopperSetup first = source_hopper(factor);
  first.name = "1: D 15 mm";
  std::vector<HopperSetup> all(5, first);
  all[1].name = "2: D 10 mm";
  all[1].equivalent_slit = 10e-3;
  all[2].name = "3: g 1.62 m/s2";
  all[2].gravity = 1.62;
  all[3].name = "4: grains twice as large, laws not scaled";
  all[3].powder.grain_diameter *= 2;
  all[3].powder.damping_over_radius /= 2;
  all[3].powder.tangential_over_radius /= 2;
  all[4].name = "5: hopper 60 mm wide";
  all[4].width = 60e-3;
  for (HopperSetup& setup : all) fit_to_grains(factor, setup);
  return all;
}

void add_limit(results::ExperimentResult& result, const std::string& name, double measured, double published,
               const std::string& unit, const std::string& source) {
  result.limits.push_back({name, measured, published, unit, source});
}

/// m/s; NaN where nothing has flowed.
double fastest_of(const std::vector<double>& speeds) {
  double fastest = std::nan("");
  for (const double speed : speeds)
    if (std::isfinite(speed)) fastest = std::fmax(fastest, std::abs(speed));
  return fastest;
}

void add_limits(const HopperSetup& setup, const HopperFields& fields, double scale,
                const continuum::LengthOfFraction& length, results::ExperimentResult& result) {
  const char* text = "Bierwisch 2009, section 5.1";
  add_limit(result, "bulk solid fraction", fields.bulk_fraction, 0.365, "1", text);
  add_limit(result, "largest vertical speed", fastest_of(fields.vertical), 0.46, "m/s", text);
  add_limit(result, "largest horizontal speed", fastest_of(fields.horizontal), 0.076, "m/s", text);
  add_limit(result, "outflow over D sqrt(gD)", fields.outflow / (scale * scale * scale / setup.gravity), 0.92,
            "1", "Bierwisch 2009, Table 5.2");
  add_limit(result, "B_0", 1e3 * length.smallest, 0.116, "mm", "Bierwisch 2009, Eq. 5.5");
  add_limit(result, "n_div", length.diverging, 0.353, "1", "Bierwisch 2009, Eq. 5.5");
  add_limit(result, "B at a solid fraction of 0.30", 1e3 * length(0.30), 0.773, "mm",
            "Bierwisch 2009, Eq. 5.5");
}

void add_model_errors(const HopperFields& fields, double width, const continuum::HopperFlow& incompressible,
                      const continuum::HopperFlow& compressible, results::ExperimentResult& result) {
  const ModelError constant = error_of(incompressible, fields, 0.25 * width, 2 * width);
  const ModelError varying = error_of(compressible, fields, 0.25 * width, 2 * width);
  const double none = std::nan("");
  add_limit(result, "error of v_z, kinematic model", constant.vertical, none, "1", "");
  add_limit(result, "error of v_x, kinematic model", constant.horizontal, none, "1", "");
  add_limit(result, "error of v_z, compressible kinematic model", varying.vertical, none, "1", "");
  add_limit(result, "error of v_x, compressible kinematic model", varying.horizontal, none, "1", "");
}

}  // namespace

void compare_hopper(const ExperimentOptions& options, results::ExperimentResult& result) {
  const double factor = options.quick ? 8 : 5;
  const int packings = options.quick ? 1 : 2;
  HopperStudy study;
  study.setups = setups(factor);
  study.fields = run_packings(options, study.setups, packings);
  const auto& all = study.setups;
  const auto& fields = study.fields;
  const double scale = speed_scale(all[0]);
  const auto points = local_lengths(fields[0], 0.1 * scale);
  const FittedLength fitted = fit_rising_branch(points, fields[0].bulk_fraction, all[0].equivalent_slit);
  study.length = fitted.length;
  study.length_at_bound = fitted.at_bound;
  study.incompressible = solve_for(fields[0], all[0].slit, continuum::constant_length(kConstant), false);
  study.compressible = solve_for(fields[0], all[0].slit, study.length, true);
  add_limits(all[0], fields[0], scale, study.length, result);
  add_model_errors(fields[0], all[0].equivalent_slit, study.incompressible, study.compressible, result);
  result.figures = hopper_figures(study);
  result.charts.push_back(length_chart(points, study.length));
  result.charts.push_back(length_field_chart(all[0], fields[0]));
  const HopperModels models{&study.incompressible, &study.compressible};
  add_profile_charts(fields[0], all[0].equivalent_slit, models, result.charts);
  add_contour_charts(fields[0], models, result.charts);
  std::vector<double> scales, widths;
  for (const auto& setup : all) {
    scales.push_back(speed_scale(setup));
    widths.push_back(setup.equivalent_slit);
  }
  add_scaling_charts(all, fields, widths, scales, result.charts);
}

}  // namespace diefill::process::laboratory
