#include "process/plan/setting.h"

#include <toml++/toml.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "process/input/shown_value.h"
#include "process/powder/material.h"
#include "process/results/formatted.h"
#include "process/scene/powder/grain_models.h"
#include "process/scene/powder/powder_presets.h"
#include "process/scene/reading/sections.h"
#include "process/scene/scene_text.h"
#include "process/setup/impact_speed.h"

namespace diefill::process::plan {

namespace {

/// A length or time that is to be written into a scene: rounded down to three digits.
double rounded_down(double value) {
  const double unit = std::pow(10, std::floor(std::log10(value)) - 2);
  return std::floor(value / unit * (1 + 1e-9)) * unit;
}

/// A grain size and what sets it.
struct Bound {
  double diameter;  ///< m
  std::string reason;
};

/// Size of the largest grain over that of mean mass, which settings choose.
double largest_over_mean(const Scene& scene) {
  return largest_grain(scene) / scene.powder.grain_diameter;
}

/// Grains must fit between periods and into the pour box (process/scene/reading/plausibility).
void bound_by_box(const Scene& scene, std::vector<Bound>& bounds) {
  const double grains_across = 4 * largest_over_mean(scene);
  for (std::size_t axis = 0; axis < 2; ++axis) {
    if (const auto period = scene.numerics.period[axis])
      bounds.push_back(
          {*period / grains_across, results::formatted("a quarter of the period of %.4g mm", 1e3 * *period)});
    const auto i = static_cast<Eigen::Index>(axis);
    const double width = scene.pour.upper[i] - scene.pour.lower[i];
    bounds.push_back({width / grains_across,
                      results::formatted("a quarter of the pour box width of %.4g mm", 1e3 * width)});
  }
}

Bound coarsest(Setting setting, const Scene& scene, const geometry::Cavity& cavity) {
  const double calibrated = calibrated_diameter(scene.powder);
  const bool quick = setting == Setting::quick;
  std::vector<Bound> bounds;
  if (setting == Setting::reference) {
    bounds.push_back({calibrated, "the calibrated size, without coarse graining"});
  } else {
    const double factor = (quick ? 2 : 1) * kProvenFactor;
    bounds.push_back(
        {factor * calibrated,
         quick ? results::formatted(
                     "%.3g times the calibrated size, above the range validated against published figures",
                     factor)
               : results::formatted(
                     "%.3g times the calibrated size, the limit of the range validated against published "
                     "figures",
                     factor)});
  }
  if (cavity.found && cavity.narrowest_width > 0) {
    const double share = quick ? kCoarsestRun : kCoarsestToDecide;
    bounds.push_back({share * cavity.narrowest_width,
                      quick ? results::formatted("%.2f of the narrowest width, a first look only", share)
                            : std::string("a third of the narrowest width")});
  }
  bound_by_box(scene, bounds);
  return *std::min_element(bounds.begin(), bounds.end(),
                           [](const Bound& a, const Bound& b) { return a.diameter < b.diameter; });
}

/// Spacing of wall spheres over their radius: with the quick setting 2.4, as in the quick start, where holes
/// stay smaller than half the powder's smallest spheres; else 1.6 (engine/STABILITY.md, walls), or 1.4, which
/// no sphere passes, where these would pass between wall spheres that are large beside them.
double spacing_for(Setting setting, const Scene& scene, double sphere_radius) {
  constexpr double kWide = 2.4, kUsual = 1.6, kTight = 1.4;
  const double wall = scene.walls.sphere_radius;
  const double smallest = sphere_radius * smallest_grain(scene) / scene.powder.grain_diameter;
  if (setting == Setting::quick && (kWide * std::numbers::sqrt2 - 2) * wall < smallest) return kWide;
  return (kUsual / std::numbers::sqrt2 - 1) * wall < smallest ? kUsual : kTight;
}

/// m: depth of powder in the shoe, with what the cavity takes spread over the pour box.
double enough_powder(const Scene& scene, const geometry::Cavity& cavity) {
  const Eigen::Vector3d size = scene.pour.upper - scene.pour.lower;
  const double cavity_takes = cavity.found ? cavity.volume / (size[0] * size[1]) : 0;
  return kEnoughPowder + cavity_takes;
}

void choose_fill_height(SettingNumbers& numbers, Setting setting, const Scene& scene,
                        const geometry::Cavity& cavity) {
  // Where the scene has a setting of its own, what stands here is the height of the pour box.
  const double given = scene.pour.fill_height, enough = enough_powder(scene, cavity);
  const bool keep = !setting_of(scene) && (setting == Setting::reference || !cavity.found);
  numbers.fill_height = keep ? given : std::min(given, enough);
  if (numbers.fill_height < given)
    numbers.reasons.push_back(results::formatted(
        "powder in the shoe %.4g mm deep: 19 mm, above which depth has no effect (Bierwisch 2009, "
        "section 4.1.6), plus what the cavity takes",
        1e3 * numbers.fill_height));
  else
    numbers.reasons.push_back(
        results::formatted("powder in the shoe %.4g mm deep, as in the scene", 1e3 * given));
}

/// Scenes write 0.47 mm for the 0.4704 mm of model D (process/scene/README.md).
double printed_over_exact(const PowderSpec& powder) {
  if (powder.clump) return 1;
  const double tabulated = facts_of(powder.model).sphere_radius;
  if (powder.name == "custom" || powder.sphere_radius != tabulated) return 1;
  return facts_of(powder.model).grain_diameter / calibrated_diameter(powder);
}

/// Lays `value` over `key` of a table, and says what stood there.
template <class Value>
void replace_in(toml::table& into, const std::string& table, const std::string& key, const Value& value,
                std::vector<std::string>& notes) {
  const auto show = [&] { return shown_value(*into.get(key)); };
  const std::string before = into.contains(key) ? show() : "";
  into.insert_or_assign(key, value);
  if (before != show())
    notes.push_back(table + "." + key + " = " + show() + (before.empty() ? "" : ", replacing " + before));
}

/// The same for [table] of the document, which is added where it is missing.
template <class Value>
void replace(toml::table& document, const std::string& table, const std::string& key, const Value& value,
             std::vector<std::string>& notes) {
  if (!document.contains(table)) document.insert(table, toml::table{});
  replace_in(*document[table].as_table(), table, key, value, notes);
}

/// In the key where powders of their kind have it.
void set_grain_size(toml::table& powder, const std::string& name, double millimetres,
                    std::vector<std::string>& notes) {
  const std::string text = results::formatted("%.4g mm", millimetres);
  if (toml::table* sizes = powder["sizes"].as_table())
    replace_in(*sizes, name + ".sizes", "mean_size", text, notes);
  else
    replace_in(powder, name, "grain_diameter", text, notes);
}

/// s, what the program chooses for grains of this diameter.
double default_time_step(const Scene& scene, double diameter) {
  Scene sized = scene;
  enlarge(sized, diameter / scene.powder.grain_diameter);
  sized.numerics.time_step.reset();
  sized.numerics.time_step_fraction = 0;
  const double fall = scene.pour.upper.z() - scene.pour.lower.z();
  return engine_settings(sized, expected_impact_speed(sized, fall)).time_step;
}

/// The published step belongs to the published laws. Other powders may be stiffer or lighter, and then need
/// the shorter step that the program chooses.
void choose_time_step(SettingNumbers& numbers, const Scene& scene, double factor) {
  constexpr double kPublishedStep = 2e-6;  // s at the calibrated size (Bierwisch 2009, Table C.4)
  const double published = kPublishedStep * factor;
  if (published <= default_time_step(scene, numbers.grain_diameter)) {
    numbers.time_step = published;
    numbers.reasons.push_back(
        results::formatted("time step of %.3g s, the published one scaled with the grain size", published));
  } else {
    numbers.reasons.push_back("time step as the program chooses, shorter than the published one");
  }
}

/// All powders become coarser by the same factor, so that their grains keep their ratios of size.
void set_sizes_of_others(toml::table& document, const Scene& scene, double factor,
                         std::vector<std::string>& notes) {
  toml::array* others = document["other_powder"].as_array();
  if (others == nullptr) return;
  for (std::size_t k = 0; k < others->size(); ++k) {
    const PowderSpec& powder = scene.other_powders[k].powder;
    set_grain_size(*others->get(k)->as_table(), "other_powder." + powder.label,
                   rounded_down(1e3 * factor * powder.grain_diameter * printed_over_exact(powder)), notes);
  }
}

}  // namespace

std::string why_no_settings(const Scene& scene) {
  const std::string sizes = " gives the grains their sizes, which settings would change";
  if (scene.pour.grains_file) return "pour.grains_file" + sizes;
  return scene.pour.state ? "pour.state" + sizes : "";
}

double calibrated_diameter(const PowderSpec& powder) {
  return powder.grain_diameter / coarse_graining_factor(powder);
}

SettingNumbers numbers_of(Setting setting, const Scene& scene, const geometry::Cavity& cavity) {
  SettingNumbers numbers;
  const Bound bound = coarsest(setting, scene, cavity);
  numbers.grain_diameter = bound.diameter;
  numbers.reasons.push_back(results::formatted("grains of %.4g mm: ", 1e3 * bound.diameter) + bound.reason);
  const double factor = bound.diameter / calibrated_diameter(scene.powder);
  const double sphere_radius = factor * scene.powder.sphere_radius;
  numbers.wall_spacing = spacing_for(setting, scene, sphere_radius);
  numbers.reasons.push_back(results::formatted("wall spheres spaced %.2g radii apart", numbers.wall_spacing));
  if (setting == Setting::reference) choose_time_step(numbers, scene, factor);
  choose_fill_height(numbers, setting, scene, cavity);
  return numbers;
}

Scene with_numbers(const Scene& scene, const SettingNumbers& numbers, const std::string& origin) {
  toml::table document = parse_scene_text(scene.text, scene.file);
  std::vector<std::string> notes = {origin};
  document.erase("setting");
  const double millimetres = rounded_down(1e3 * numbers.grain_diameter * printed_over_exact(scene.powder));
  if (!document.contains("powder")) document.insert("powder", toml::table{});
  set_grain_size(*document["powder"].as_table(), "powder", millimetres, notes);
  set_sizes_of_others(document, scene, numbers.grain_diameter / scene.powder.grain_diameter, notes);
  if (document.contains("numerics"))
    for (const char* key : {"time_step", "time_step_fraction"}) document["numerics"].as_table()->erase(key);
  if (numbers.time_step)
    replace(document, "numerics", "time_step", results::formatted("%.4g us", 1e6 * *numbers.time_step),
            notes);
  replace(document, "walls", "spacing", numbers.wall_spacing, notes);
  replace(document, "pour", "fill_height",
          results::formatted("%.4g mm", rounded_down(1e3 * numbers.fill_height)), notes);
  try {
    return scene_of(document, as_comment(notes) + scene_text_of(document), scene.file);
  } catch (const SceneError& error) {
    throw SceneError(std::string(error.what()) + " (chosen by " + origin + ")");
  }
}

}  // namespace diefill::process::plan
