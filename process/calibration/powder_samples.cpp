#include "process/calibration/powder_samples.h"

#include <toml++/toml.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "process/calibration/key_node.h"
#include "process/compare/statistics.h"
#include "process/input/shown_value.h"
#include "process/input/table_reader.h"
#include "process/results/figure_table.h"
#include "process/results/studies/quantiles.h"
#include "process/scene/key_path.h"
#include "process/scene/powder/powder_file.h"
#include "process/scene/scene_text.h"

namespace diefill::process::calibration {
namespace {

constexpr NumberRule kFitted = {-1e12, 1e12, false, "0.25"};

/// The parameters that were fitted, into keys, units and best values of the region.
void read_fitted(TableReader& calibration, PowderRegion& region) {
  for (TableReader& parameter : calibration.tables("parameter")) {
    const std::string key = parameter.required_text("key", "powder.friction");
    if (!is_key_path(key))
      parameter.reject("key", "expected the path of a key alone, such as \"powder.friction\"");
    region.keys.push_back(key);
    region.units.push_back(parameter.text("unit").value_or("1"));
    parameter.require("best", "0.25");
    region.best.push_back(*parameter.number("best", kFitted));
  }
}

[[noreturn]] void refuse_sample(const toml::node& sample, const PowderRegion& region) {
  throw SceneError(region.file.string() + ':' + std::to_string(sample.source().begin.line) +
                   ": calibration.samples: found " + shown_value(sample) +
                   ", expected a list of one number for each [[calibration.parameter]], " +
                   std::to_string(region.keys.size()) + " in all, as diefill calibrate writes them");
}

/// A row for each powder, as the file has them.
std::vector<std::vector<double>> samples_in(const toml::table& calibration, const PowderRegion& region) {
  std::vector<std::vector<double>> samples;
  const toml::array* rows = calibration["samples"].as_array();
  if (rows == nullptr) return samples;
  for (const toml::node& node : *rows) {
    const toml::array* row = node.as_array();
    if (row == nullptr || row->size() != region.keys.size()) refuse_sample(node, region);
    samples.emplace_back();
    for (const toml::node& value : *row) {
      const auto number = value.is_number() ? value.value<double>() : std::nullopt;
      if (!number || !std::isfinite(*number)) refuse_sample(node, region);
      samples.back().push_back(*number);
    }
  }
  return samples;
}

std::string assignments(const PowderRegion& region, const std::vector<double>& values) {
  std::string lines;
  for (std::size_t k = 0; k < values.size(); ++k) {
    char number[40];
    std::snprintf(number, sizeof number, "%.8g", values[k]);
    lines += assignment_line(region.keys[k], number, region.units[k]);
  }
  return lines;
}

/// A key of the scene file that the samples set, too: the best powder's runs would keep the scene's value.
[[noreturn]] void refuse_own_value(const toml::node& node, const std::string& key, const Scene& scene,
                                   const PowderRegion& region) {
  const auto& at = node.source().begin;
  throw SceneError(scene.file.string() + ':' + std::to_string(at.line) + ':' + std::to_string(at.column) +
                   ": " + key + ": found " + shown_value(node) + ", but --powder-samples draws it from " +
                   region.file.filename().string() +
                   "; remove the key from the scene, or run without --powder-samples");
}

/// A sample of the region where its scene has walls and stiffness that the powder was fitted with: what the
/// sample itself changes of these is no difference to warn of.
Scene as_fitted(const Scene& scene, const Scene& sample) {
  if (!fitted_with_warning(scene).empty() || fitted_with_warning(sample).empty()) return sample;
  SceneChanges changes;
  changes.source = "--powder-samples";
  changes.set = fitted_with_text(fitted_with_of(sample, ""));
  return changed_scene(sample.text, sample.file, changes);
}

Variant variant_of(const Scene& scene, const std::string& name, const std::string& folder,
                   const std::string& set, int seeds_later) {
  SceneChanges changes;
  changes.source = "--powder-samples";
  changes.set = set;
  Variant variant{name, folder, as_fitted(scene, changed_scene(scene.text, scene.file, changes))};
  variant.scene.seed = scene.seed + static_cast<std::uint64_t>(seeds_later);
  return variant;
}

/// The scatter, or 0 where it is the rounding of equal values alone.
double without_rounding(double scatter, const results::SpreadFigure& figure) {
  constexpr double kRounding = 1e-12;  // of the largest value
  double largest = 0;
  for (const auto* values : {&figure.of_seeds, &figure.of_powders})
    for (const double value : *values)
      if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
  return scatter <= kRounding * largest ? 0 : scatter;
}

/// Whether powders scatter more than seeds do: with few runs the variances differ by chance, too.
bool significant(const Sample& powders, const Sample& seeds) {
  constexpr double kByChance = 0.1;
  if (powders.count < 2 || seeds.count < 2) return false;
  const double ratio = results::variance_ratio_exceeded(static_cast<double>(powders.count - 1),
                                                        static_cast<double>(seeds.count - 1), kByChance);
  return powders.scatter * powders.scatter > ratio * seeds.scatter * seeds.scatter;
}

}  // namespace

PowderRegion powder_region_of(const std::filesystem::path& scene_file) {
  const toml::table scene = parse_scene_text(load_scene_text(scene_file), scene_file);
  const auto name = scene["powder"]["file"].value<std::string>();
  if (!name)
    throw SceneError(
        scene_file.string() +
        ": --powder-samples: the scene has no powder.file; give one that diefill calibrate wrote");
  PowderRegion region;
  region.file = scene_file.parent_path() / *name;
  const toml::table powder = parse_scene_text(load_scene_text(region.file), region.file);
  if (auto calibration = TableReader(powder, region.file, "").table("calibration")) {
    read_fitted(*calibration, region);
    if (!region.keys.empty()) region.samples = samples_in(*powder["calibration"].as_table(), region);
  }
  if (region.samples.empty())
    throw SceneError(region.file.string() +
                     ": --powder-samples: found no [calibration] with samples of the powder; expected a file "
                     "that diefill calibrate wrote");
  return region;
}

void refuse_own_values(const Scene& scene, const PowderRegion& region) {
  const toml::table own = parse_scene_text(load_scene_text(scene.file), scene.file);
  const std::string of_file = load_scene_text(region.file);
  for (const std::string& key : region.keys) {
    if (const toml::node* node = node_of_key(own, key)) refuse_own_value(*node, key, scene, region);
    if (value_at(scene.text, scene.file, key) != value_at(of_file, region.file, key))
      throw SceneError("--powder-samples: it draws " + key + " from " + region.file.filename().string() +
                       ", but --set, --setting or a [contact] of the scene replaces the value there; leave "
                       "that out, or run without --powder-samples");
  }
}

std::vector<std::vector<double>> drawn_samples(const PowderRegion& region, int count, std::uint64_t seed) {
  const std::size_t all = region.samples.size(), wanted = static_cast<std::size_t>(count);
  if (wanted > all)
    throw SceneError("--powder-samples: found " + std::to_string(count) + ", allowed: at most " +
                     std::to_string(all) + ", as many as " + region.file.string() + " has");
  std::vector<std::vector<double>> drawn;
  const std::size_t start = static_cast<std::size_t>(seed % all);
  for (std::size_t k = 0; k < wanted; ++k) drawn.push_back(region.samples[(start + k * all / wanted) % all]);
  return drawn;
}

std::vector<Variant> powder_variants(const Scene& scene, const PowderRegion& region,
                                     const std::vector<std::vector<double>>& powders, int seeds) {
  std::vector<Variant> variants;
  for (int k = 0; k < seeds; ++k)
    variants.push_back(variant_of(scene, "best powder, run " + std::to_string(k + 1),
                                  "best_" + std::to_string(k + 1), "", k));
  for (std::size_t k = 0; k < powders.size(); ++k)
    variants.push_back(variant_of(scene, "powder " + std::to_string(k + 1), "powder_" + std::to_string(k + 1),
                                  assignments(region, powders[k]), seeds + static_cast<int>(k)));
  return variants;
}

results::SpreadFigure spread_of(const results::ComparedMeasure& measure,
                                const std::vector<results::ComparedRun>& runs, std::size_t seeds) {
  results::SpreadFigure figure{measure.key, measure.name, measure.unit, {}, {}};
  for (std::size_t k = 0; k < runs.size(); ++k) {
    const auto found = runs[k].values.find(measure.key);
    (k < seeds ? figure.of_seeds : figure.of_powders)
        .push_back(found == runs[k].values.end() ? std::numeric_limits<double>::quiet_NaN() : found->second);
  }
  const results::Figure* known = results::find_figure(measure.key);
  const double period = known == nullptr ? 0 : known->shown.period;
  Sample best = sample_of(figure.of_seeds, period), powders = sample_of(figure.of_powders, period);
  for (Sample* sample : {&best, &powders}) sample->scatter = without_rounding(sample->scatter, figure);
  figure.best = best.mean;
  figure.scatter = best.scatter;
  figure.mean = powders.mean;
  figure.spread = powders.scatter;
  figure.powder = std::sqrt(std::max(0.0, powders.scatter * powders.scatter - best.scatter * best.scatter));
  if (!std::isfinite(powders.scatter) || !std::isfinite(best.scatter))
    figure.powder = std::numeric_limits<double>::quiet_NaN();
  figure.significant = significant(powders, best);
  return figure;
}

results::PowderSpread powder_spread(const std::filesystem::path& directory, const PowderRegion& region,
                                    const std::vector<std::vector<double>>& powders, int seeds) {
  const results::Comparison comparison = collect(directory);
  results::PowderSpread spread;
  spread.title = comparison.title;
  spread.powder_file = region.file.filename().string();
  spread.keys = region.keys;
  spread.units = region.units;
  spread.best = region.best;
  spread.powders = powders;
  for (const auto& run : comparison.runs)
    if (run.state != "finished") spread.failed.push_back(run.variant + ": " + run.state + ", " + run.reason);
  for (const auto& measure : comparison.measures)
    spread.figures.push_back(spread_of(measure, comparison.runs, static_cast<std::size_t>(seeds)));
  return spread;
}

}  // namespace diefill::process::calibration
