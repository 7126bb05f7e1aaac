// How coarse grains may be for a cavity: a slot and a ring filled from above, with and without the correction
// for the empty annulus (Bierwisch 2009, section 3.2: an opening acts as if narrower by 1.4 d).
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <string>

#include "engine/simulation/simulation.h"
#include "process/laboratory/stability/profile_walls.h"
#include "process/laboratory/stability/registry.h"
#include "process/laboratory/stability/trial.h"
#include "process/powder/empty_annulus.h"
#include "process/powder/material.h"
#include "process/tooling/rest.h"

namespace diefill::process::laboratory {

namespace {

using results::ExperimentSeries;
using Role = ExperimentSeries::Role;

constexpr double kWidth = 8e-3, kDepth = 12e-3;  // m, of the slot and the ring, and how deep they are
constexpr double kOneSeed = 0.2;                 // d / b below which a ring is filled once
constexpr double kPublished = 0.47 / 2.488;      // d / b of the source's narrow ring
constexpr double kBedFraction = 0.39;            // solid, of a wide bed (STABILITY.md, time step)

/// A cavity below z = 0 with powder above it, in a mesh of triangles.
struct Cavity {
  bool ring = false;    ///< about z, inner radius kWidth / 2; else a slot along y
  double width = 0;     ///< m
  double diameter = 0;  ///< m, d of model D

  double inner() const { return 0.5 * kWidth; }
  double outer() const { return inner() + width; }
  /// m, along y, which repeats.
  double length() const { return 4 * diameter; }
  /// m^2, seen from above, of a cavity that is kWidth wide.
  double nominal_area() const {
    const double radius = inner() + kWidth;
    return ring ? std::numbers::pi * (radius * radius - inner() * inner()) : kWidth * length();
  }
  /// m, from the middle to the walls of the box that powder is poured into.
  double reach() const { return (ring ? outer() : 0.5 * width) + 1.5 * diameter; }
};

engine::WallBodySpec walls_of(const Cavity& cavity, double top) {
  engine::WallBodySpec body;
  body.name = "cavity";
  const double reach = cavity.reach();
  if (cavity.ring) {
    add_about_z(body, {{0, 0},
                       {cavity.inner(), 0},
                       {cavity.inner(), -kDepth},
                       {cavity.outer(), -kDepth},
                       {cavity.outer(), 0},
                       {reach, 0},
                       {reach, top}});
    return body;
  }
  const double half = 0.5 * cavity.width;
  add_along_y(body,
              {{-reach, top},
               {-reach, 0},
               {-half, 0},
               {-half, -kDepth},
               {half, -kDepth},
               {half, 0},
               {reach, 0},
               {reach, top}},
              cavity.length() + 2 * cavity.diameter);
  return body;
}

/// Grains on a lattice over the box, enough to fill the cavity twice.
std::vector<engine::NewGrain> rain(const Cavity& cavity, double solid_volume, std::uint64_t seed) {
  const double spacing = 1.1 * cavity.diameter, edge = cavity.reach() - 0.55 * cavity.diameter;
  const auto wanted = static_cast<std::size_t>(2 * 0.4 * cavity.nominal_area() * cavity.width / kWidth *
                                               kDepth / solid_volume);
  std::vector<engine::NewGrain> grains;
  std::mt19937_64 generator(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const auto random = [&] { return uniform(generator); };
  const double half = cavity.ring ? edge : 0.5 * cavity.length();
  for (int layer = 0; grains.size() < wanted; ++layer)
    for (double y = -half + 0.5 * spacing; y < half - 0.4 * spacing; y += spacing)
      for (double x = -edge; x <= edge; x += spacing) {
        if (cavity.ring && std::hypot(x, y) > edge) continue;
        engine::NewGrain grain;
        grain.position = {x, y, (layer + 0.6) * spacing};
        grain.orientation = engine::Quaternion(random(), random(), random(), random()).normalized();
        grain.velocity = 0.02 * Eigen::Vector3d(random(), random(), 0);
        grains.push_back(grain);
      }
  return grains;
}

/// Solid volume of the grains in the cavity over the volume of one that is kWidth wide.
double filled_share(const Cavity& cavity, std::uint64_t seed, int threads) {
  Scene scene;
  scene.powder.grain_diameter = cavity.diameter;
  if (!cavity.ring) scene.numerics.period[1] = cavity.length();
  auto settings = engine_settings(scene, 0.8);
  settings.threads = threads;
  const auto grains = rain(cavity, settings.shape().solid_volume, seed);
  double top = 0;
  for (const auto& grain : grains) top = std::max(top, grain.position.z());
  engine::Simulation simulation(settings, {walls_of(cavity, top + 2 * cavity.diameter)});
  simulation.add_grains(grains);
  RestWatch rest;
  constexpr double kLongest = 1;  // s
  do {
    for (int k = 0; k < 50; ++k) simulation.step();
  } while (simulation.time() < kLongest && !rest.at_rest(simulation, cavity.diameter));
  const auto& places = simulation.grains().position;
  const auto inside = std::count_if(places.begin(), places.end(), [](const Eigen::Vector3d& place) {
    return place.z() < 0 && place.z() > -kDepth;
  });
  return static_cast<double>(inside) * settings.shape().solid_volume / (cavity.nominal_area() * kDepth);
}

/// Between two of rising `shares`, on straight lines through `held`.
double at_share(const std::vector<double>& shares, const std::vector<double>& held, double share) {
  std::size_t k = 1;
  while (k + 1 < shares.size() && shares[k] < share) ++k;
  const double part = (share - shares[k - 1]) / (shares[k] - shares[k - 1]);
  return held[k - 1] + part * (held[k] - held[k - 1]);
}

/// Largest d / b at which a cavity holds within 5 % of what it holds with the published grains.
double usable_coarseness(const std::vector<double>& shares, const std::vector<double>& held) {
  constexpr double kStep = 1e-3, kLost = 0.05;
  const double least = (1 - kLost) * at_share(shares, held, kPublished);
  double share = kPublished;
  while (share < shares.back() && at_share(shares, held, share + kStep) >= least) share += kStep;
  return share;
}

void fill(bool ring, const std::vector<double>& coarseness, const ExperimentOptions& options,
          results::ExperimentResult& result) {
  const std::string what = ring ? "ring" : "slot";
  results::ExperimentChart chart;
  chart.name = "cavity_" + what;
  chart.title = "Powder in a " + what + " 8 mm wide and 12 mm deep";
  chart.subtitle = "Filled from above by model D; solid volume over the volume of the cavity";
  chart.note = "Wider: the cavity is made 1.4 d wider. Empty annulus: 0.39 in all but 1.4 d of the width.";
  chart.x = {.label = "Grain diameter over width"};
  chart.y = {.label = "Solid volume over nominal volume", .lower = 0};
  ExperimentSeries plain{.name = "as it is", .x = coarseness, .y = {}};
  ExperimentSeries wider{.name = "1.4 d wider", .x = coarseness, .y = {}};
  ExperimentSeries theory{.name = "empty annulus", .role = Role::predicted, .x = coarseness, .y = {}};
  ExperimentSeries bed{.name = "a wide bed, 0.39", .role = Role::predicted, .x = coarseness, .y = {}};
  bed.y.assign(coarseness.size(), kBedFraction);
  for (const double share : coarseness) {
    // Fine grains scatter least and cost most: one seed in a ring below d = b / 4.
    const std::uint64_t seeds = options.quick || (ring && share < kOneSeed) ? 1 : 3;
    Cavity cavity{.ring = ring, .width = kWidth, .diameter = share * kWidth};
    Cavity widened = cavity;
    widened.width += kEmptyAnnulus * cavity.diameter;
    double as_is = 0, when_wider = 0;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
      as_is += filled_share(cavity, seed, options.threads) / static_cast<double>(seeds);
      when_wider += filled_share(widened, seed, options.threads) / static_cast<double>(seeds);
    }
    plain.y.push_back(as_is);
    wider.y.push_back(when_wider);
    theory.y.push_back(kBedFraction * std::max(0.0, 1 - kEmptyAnnulus * share));
    const std::string name = what + ", d / b = " + std::to_string(share).substr(0, 5);
    result.limits.push_back(
        {name + ": solid volume over nominal volume", as_is, theory.y.back(), "1", "empty annulus of 1.4 d"});
    result.limits.push_back(
        {name + ", 1.4 d wider: the same", when_wider, kBedFraction, "1", "a bed of model D"});
  }
  if (ring && coarseness.front() < kPublished)
    result.figures.push_back(
        {"M03", usable_coarseness(coarseness, plain.y), "filled from above", kWidth * coarseness.back()});
  chart.series = {plain, wider, theory, bed};
  result.charts.push_back(chart);
}

}  // namespace

void find_cavity_limit(const ExperimentOptions& options, results::ExperimentResult& result) {
  using Shares = std::vector<double>;
  const Shares all = {0.125, 1.0 / 6, 0.25, 1.0 / 3, 0.5, 0.75, 1};
  fill(false, options.quick ? Shares{0.25, 1.0 / 3, 0.5, 1} : all, options, result);
  fill(true, options.quick ? Shares{0.5, 1} : all, options, result);
}

}  // namespace diefill::process::laboratory
