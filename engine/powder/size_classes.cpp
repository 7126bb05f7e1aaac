#include "engine/powder/size_classes.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <stdexcept>
#include <string>

namespace diefill::engine {

namespace {

/// Share of grains, and of mass, left to the class at either end and what lies beyond.
constexpr double kTail = 1e-3;

std::vector<CutClass> own_classes(const SizeDistribution& distribution, std::size_t count) {
  std::vector<CutClass> classes;
  double below = 0;
  for (const double diameter : distribution.class_diameters()) {
    const double up_to = distribution.fraction_below(diameter, SizeBasis::number);
    classes.push_back({diameter, up_to - below});
    below = up_to;
  }
  if (classes.size() > count)
    throw std::invalid_argument("the size distribution has " + std::to_string(classes.size()) +
                                " classes, but at most " + std::to_string(count) + " are allowed");
  return classes;
}

/// Borders between the classes, m.
std::vector<double> borders_of(const SizeDistribution& distribution, std::size_t count) {
  const double low = std::log(distribution.quantile(kTail, SizeBasis::number));
  const double high = std::log(distribution.quantile(1 - kTail, SizeBasis::mass));
  std::vector<double> borders;
  for (std::size_t k = 1; k < count; ++k)
    borders.push_back(std::exp(low + (high - low) * static_cast<double>(k) / static_cast<double>(count)));
  return borders;
}

}  // namespace

std::vector<CutClass> size_classes(const SizeDistribution& distribution, std::size_t count) {
  if (count == 0) throw std::invalid_argument("a size distribution needs at least one class");
  if (!distribution.class_diameters().empty()) return own_classes(distribution, count);
  const double cubes = distribution.moment(3);
  auto borders = borders_of(distribution, count);
  borders.push_back(std::numeric_limits<double>::infinity());
  std::vector<CutClass> classes;
  double numbers_below = 0, mass_below = 0;
  for (const double border : borders) {
    const bool last = std::isinf(border);
    const double numbers = last ? 1 : distribution.fraction_below(border, SizeBasis::number);
    const double mass = last ? 1 : distribution.fraction_below(border, SizeBasis::mass);
    const double number_share = numbers - numbers_below, mass_share = mass - mass_below;
    if (number_share > 0 && mass_share > 0)
      classes.push_back({std::cbrt(cubes * mass_share / number_share), number_share});
    numbers_below = numbers;
    mass_below = mass;
  }
  return classes;
}

std::vector<std::size_t> class_counts(const std::vector<CutClass>& classes, std::size_t grains) {
  std::vector<std::size_t> counts(classes.size());
  std::vector<double> remainder(classes.size());
  std::size_t given = 0;
  for (std::size_t c = 0; c < classes.size(); ++c) {
    const double wanted = classes[c].number_share * static_cast<double>(grains);
    counts[c] = static_cast<std::size_t>(wanted);
    remainder[c] = wanted - static_cast<double>(counts[c]);
    given += counts[c];
  }
  std::vector<std::size_t> order(classes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return remainder[a] > remainder[b]; });
  for (std::size_t k = 0; given < grains; k = (k + 1) % order.size(), ++given) ++counts[order[k]];
  return counts;
}

std::vector<std::uint16_t> drawn_classes(const std::vector<CutClass>& classes, std::size_t grains,
                                         std::uint64_t seed) {
  const auto counts = class_counts(classes, grains);
  std::vector<std::uint16_t> drawn;
  drawn.reserve(grains);
  for (std::size_t c = 0; c < counts.size(); ++c)
    drawn.insert(drawn.end(), counts[c], static_cast<std::uint16_t>(c));
  std::mt19937_64 random(seed);  // std::shuffle may differ between libraries
  for (std::size_t k = drawn.size(); k > 1; --k) {
    const double uniform = static_cast<double>(random() >> 11) * 0x1p-53;
    std::swap(drawn[k - 1], drawn[static_cast<std::size_t>(uniform * static_cast<double>(k))]);
  }
  return drawn;
}

}  // namespace diefill::engine
