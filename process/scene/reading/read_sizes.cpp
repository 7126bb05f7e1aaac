#include <algorithm>
#include <cmath>

#include "process/input/numbers_apart.h"
#include "process/scene/contact/contact_spec.h"
#include "process/scene/reading/plausibility.h"
#include "process/scene/reading/sections.h"
#include "process/scene/setting.h"

namespace diefill::process {
namespace {

using engine::SizeBasis;
using engine::SizeCutOffs;
using engine::SizeDistribution;

constexpr QuantityRule kDiameter = {Dimension::length, "1.5 mm", "0 mm", "100 mm", true};
constexpr QuantityRule kDeviation = {Dimension::length, "0.3 mm", "0 mm", "100 mm", true};
constexpr NumberRule kShare = {0, 1e9, true, "0.3"};
constexpr NumberRule kLogDeviation = {0, 2, true, "0.2"};
constexpr std::int64_t kMaxClasses = 32;
constexpr std::size_t kUsualClasses = 8;
/// Largest over smallest grain. Pairs of unequal spheres are tested up to 100
/// (tests/engine/limits/size_ratio_test.cpp); beds of log-normal sizes need 40 (Hu 2024, section 6.3).
constexpr double kWidest = 50;

enum class Shape { classes, log_normal };

std::string millimetres(double length) {
  return number_text(length * 1e3) + " mm";
}

SizeBasis read_basis(TableReader& table) {
  static const Choices<SizeBasis> choices = {{"mass", SizeBasis::mass}, {"number", SizeBasis::number}};
  return table.choice("basis", choices).value_or(SizeBasis::mass);
}

SizeCutOffs read_cut_offs(TableReader& table) {
  SizeCutOffs cut_offs;
  cut_offs.smallest = table.quantity("smallest", kDiameter).value_or(cut_offs.smallest);
  cut_offs.largest = table.quantity("largest", kDiameter).value_or(cut_offs.largest);
  if (cut_offs.smallest >= cut_offs.largest)
    table.reject("largest", "it must be greater than smallest, which is " +
                                numbers_apart(1e3 * cut_offs.smallest, 1e3 * cut_offs.largest).first + " mm");
  return cut_offs;
}

std::vector<engine::SizeClass> read_class_list(TableReader& table) {
  table.require("classes",
                "[{ diameter = \"1.5 mm\", share = 0.3 }, { diameter = \"2.1 mm\", share = 0.7 }]");
  std::vector<engine::SizeClass> classes;
  for (TableReader& entry : table.tables("classes")) {
    const double diameter = entry.required_quantity("diameter", kDiameter);
    entry.require("share", "0.3");
    const double share = *entry.number("share", kShare);
    entry.finish();
    const auto same = [&](const engine::SizeClass& other) { return other.diameter == diameter; };
    if (std::any_of(classes.begin(), classes.end(), same))
      entry.reject("diameter", "another class has this diameter; merge the two and add their shares");
    classes.push_back({diameter, share});
  }
  if (classes.empty() || classes.size() > static_cast<std::size_t>(kMaxClasses))
    table.reject("classes",
                 std::to_string(classes.size()) + " classes, allowed: 1 to " + std::to_string(kMaxClasses));
  return classes;
}

/// The class list cut at the limits; a sieve leaves whole classes.
SizeDistribution read_classes(TableReader& table) {
  const auto classes = read_class_list(table);
  const SizeBasis basis = read_basis(table);
  const SizeCutOffs cut_offs = read_cut_offs(table);
  const auto kept = [&](const engine::SizeClass& one) {
    return one.diameter >= cut_offs.smallest && one.diameter <= cut_offs.largest;
  };
  if (std::none_of(classes.begin(), classes.end(), kept))
    table.reject(table.has("smallest") ? "smallest" : "largest",
                 "none of the classes lies between smallest and largest; widen them");
  return SizeDistribution::discrete(classes, basis, cut_offs);
}

SizeDistribution read_log_normal(TableReader& table) {
  const SizeBasis basis = read_basis(table);
  const SizeCutOffs cut_offs = read_cut_offs(table);
  const auto mean = table.quantity("mean", kDiameter), deviation = table.quantity("deviation", kDeviation);
  const auto median = table.quantity("median", kDiameter);
  const auto log_deviation = table.number("log_deviation", kLogDeviation);
  if (mean || deviation) {
    if (median || log_deviation)
      table.reject(median ? "median" : "log_deviation",
                   "mean and deviation already define the distribution; remove one of the two pairs");
    if (!mean) table.require("mean", "\"1.9 mm\"");
    if (!deviation) table.require("deviation", "\"0.3 mm\"");
    if (basis == SizeBasis::mass)
      table.reject(table.has("basis") ? "basis" : "mean",
                   "mean and deviation refer to the number of grains; write basis = \"number\", or give "
                   "median and log_deviation");
    return SizeDistribution::log_normal_of_mean(*mean, *deviation, cut_offs);
  }
  if (!median) table.require("median", "\"1.9 mm\"");
  if (!log_deviation) table.require("log_deviation", "0.2");
  return SizeDistribution::log_normal(*median, *log_deviation, basis, cut_offs);
}

std::vector<engine::CutClass> cut_into_classes(TableReader& table, Shape shape) {
  const SizeDistribution distribution =
      shape == Shape::classes ? read_classes(table) : read_log_normal(table);
  std::size_t count = static_cast<std::size_t>(kMaxClasses);
  if (shape == Shape::log_normal)
    count =
        static_cast<std::size_t>(table.integer("number_of_classes", 2, kMaxClasses).value_or(kUsualClasses));
  table.finish();
  return engine::size_classes(distribution, count);
}

std::string description(TableReader& table, Shape shape, const std::vector<engine::CutClass>& classes) {
  return std::string(shape == Shape::classes ? "" : "log-normal, ") + std::to_string(classes.size()) +
         " classes from " + millimetres(classes.front().diameter) + " to " +
         millimetres(classes.back().diameter) +
         (read_basis(table) == SizeBasis::mass ? ", shares by mass" : ", shares by number");
}

/// m, of the grain whose mass is the mean of all.
double diameter_of_mean_mass(const std::vector<engine::CutClass>& classes) {
  double cubes = 0;
  for (const auto& one : classes) cubes += one.number_share * std::pow(one.diameter, 3);
  return std::cbrt(cubes);
}

}  // namespace

void read_sizes(TableReader& powder_table, PowderSpec& powder) {
  auto table = powder_table.table("sizes");
  if (!table) return;
  if (powder_table.has("grain_diameter"))
    powder_table.reject("grain_diameter", "[powder.sizes] in line " + std::to_string(table->line()) +
                                              " sets the grain sizes; remove one of the two");
  static const Choices<Shape> shapes = {{"classes", Shape::classes}, {"log-normal", Shape::log_normal}};
  const Shape shape = table->required_choice("distribution", shapes);
  const auto mean_size = table->quantity("mean_size", kDiameter);
  std::vector<engine::CutClass> classes;
  try {
    classes = cut_into_classes(*table, shape);
  } catch (const std::invalid_argument& reason) {
    table->reject("distribution", std::string("but ") + reason.what());
  }
  const double widest = classes.back().diameter / classes.front().diameter;
  if (widest > kWidest * (1 + 1e-9))
    table->reject("distribution",
                  "the largest grains (" + millimetres(classes.back().diameter) + ") are " +
                      numbers_apart(widest, kWidest).first + " times the size of the smallest (" +
                      millimetres(classes.front().diameter) + "), allowed: up to " + number_text(kWidest) +
                      " times; cut the distribution off with smallest and largest");
  powder.grain_diameter = diameter_of_mean_mass(classes);
  if (mean_size) {
    const double factor = *mean_size / powder.grain_diameter;
    for (auto& one : classes) one.diameter *= factor;
    powder.grain_diameter = *mean_size;
  }
  if (classes.size() == 1) return;  // of one size after all
  powder.sizes_text = description(*table, shape, classes);
  powder.sizes = std::move(classes);
}

double smallest_grain(const PowderSpec& powder) {
  return powder.sizes.empty() ? powder.grain_diameter : powder.sizes.front().diameter;
}

double largest_grain(const PowderSpec& powder) {
  return powder.sizes.empty() ? powder.grain_diameter : powder.sizes.back().diameter;
}

void enlarge(PowderSpec& powder, double factor) {
  powder.grain_diameter *= factor;
  for (auto& one : powder.sizes) one.diameter *= factor;
}

std::vector<double> grain_diameters(const PowderSpec& powder) {
  if (powder.sizes.empty()) return {powder.grain_diameter};
  std::vector<double> diameters;
  for (const auto& one : powder.sizes) diameters.push_back(one.diameter);
  return diameters;
}

}  // namespace diefill::process
