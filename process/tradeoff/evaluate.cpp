#include "process/tradeoff/evaluate.h"

#include <algorithm>
#include <cmath>

#include "process/results/formatted.h"
#include "process/results/none.h"
#include "process/results/studies/quantiles.h"

namespace diefill::process {
namespace {

using results::Tradeoff;
using results::TradeoffPoint;
using results::TradeoffQuantity;
using results::TradeoffValue;

const TradeoffQuantity* quantity_called(const Tradeoff& tradeoff, const std::string& key) {
  for (const auto& quantity : tradeoff.quantities)
    if (quantity.key == key) return &quantity;
  return nullptr;
}

/// What errors of a quantity are fractions of.
double scale_of(const Tradeoff& tradeoff, const TradeoffQuantity& quantity) {
  const TradeoffQuantity* scale =
      quantity.scale.empty() ? &quantity : quantity_called(tradeoff, quantity.scale);
  return scale == nullptr ? kNone : std::abs(scale->reference);
}

std::vector<TradeoffValue> values_of(const Tradeoff& tradeoff, std::size_t quantity) {
  std::vector<TradeoffValue> values;
  for (const TradeoffPoint& point : tradeoff.points)
    if (quantity < point.values.size()) values.push_back(point.values[quantity]);
  return values;
}

std::uint64_t most_seeds(const std::vector<TradeoffValue>& values) {
  std::uint64_t most = 0;
  for (const TradeoffValue& value : values) most = std::max(most, value.seeds);
  return most;
}

void set_references(Tradeoff& tradeoff, const TradeoffPoint& reference) {
  for (std::size_t q = 0; q < tradeoff.quantities.size(); ++q) {
    TradeoffQuantity& quantity = tradeoff.quantities[q];
    if (!quantity.is_target)
      quantity.reference = q < reference.values.size() ? reference.values[q].mean : kNone;
  }
}

void set_floors(Tradeoff& tradeoff, const TradeoffPoint& reference) {
  tradeoff.floor = kNone;
  for (std::size_t q = 0; q < tradeoff.quantities.size(); ++q) {
    TradeoffQuantity& quantity = tradeoff.quantities[q];
    const auto values = values_of(tradeoff, q);
    const PooledScatter pooled = pooled_scatter(values, scale_of(tradeoff, quantity));
    std::optional<std::uint64_t> of_reference;  // none: a target has no scatter
    if (!quantity.is_target) of_reference = q < reference.values.size() ? reference.values[q].seeds : 0;
    quantity.scatter = pooled.scatter;
    quantity.floor = error_floor(pooled, most_seeds(values), of_reference);
    for (TradeoffPoint& point : tradeoff.points)
      if (q < point.values.size())
        point.values[q].floor = error_floor(pooled, point.values[q].seeds, of_reference);
    if (quantity.decides && std::isfinite(quantity.floor))
      tradeoff.floor = std::isnan(tradeoff.floor) ? quantity.floor : std::max(tradeoff.floor, quantity.floor);
  }
}

/// Error below which a setting is as good as the reference.
double limit_of(const TradeoffValue& value, double tolerance) {
  return std::isfinite(value.floor) ? std::max(value.floor, tolerance) : tolerance;
}

/// A setting without a value that the reference has cannot be judged: its error is NaN then.
void set_errors(const Tradeoff& tradeoff, TradeoffPoint& point) {
  point.error = kNone;
  point.worst.clear();
  point.beyond.clear();
  bool judged = true;
  for (std::size_t q = 0; q < point.values.size(); ++q) {
    const TradeoffQuantity& quantity = tradeoff.quantities[q];
    const double scale = scale_of(tradeoff, quantity);
    TradeoffValue& value = point.values[q];
    value.error = scale > 0 ? std::abs(value.mean - quantity.reference) / scale : kNone;
    if (!quantity.decides || !(scale > 0) || !std::isfinite(quantity.reference)) continue;
    judged = judged && std::isfinite(value.error);
    if (value.error > limit_of(value, tradeoff.tolerance)) point.beyond.push_back(quantity.key);
    if (std::isnan(point.error) || value.error > point.error) {
      point.error = value.error;
      point.worst = quantity.key;
    }
  }
  if (!judged) point.error = kNone;
}

std::string percent_with_tenths_below_ten(double share) {
  return results::formatted(share < 0.1 ? "%.1f %%" : "%.0f %%", 100 * share);
}

/// How much less a setting costs than the reference.
std::string saving(double cost, double reference) {
  const double factor = reference / cost;
  if (factor < 1.2) return percent_with_tenths_below_ten(1 - cost / reference) + " cheaper";
  return results::formatted(factor < 10 ? "%.1f times cheaper" : "%.0f times cheaper", factor);
}

/// What a setting's error is within, as text.
std::string limit_text(const TradeoffValue& value, double tolerance) {
  return value.floor > tolerance ? "the " + percent_with_tenths_below_ten(value.floor) + " scatter over seeds"
                                 : "the tolerance of " + percent_with_tenths_below_ten(tolerance);
}

std::string advice_for(const Tradeoff& tradeoff, const TradeoffPoint& chosen,
                       const TradeoffPoint& reference) {
  if (&chosen == &reference)
    return "Take \"" + chosen.name +
           "\": no cheaper setting stays within tolerance and scatter for every quantity.";
  std::string words = "Take \"" + chosen.name + "\": " + saving(chosen.core_seconds, reference.core_seconds) +
                      " than \"" + reference.name + "\", error " +
                      percent_with_tenths_below_ten(chosen.error);
  for (std::size_t q = 0; q < chosen.values.size(); ++q)
    if (tradeoff.quantities[q].key == chosen.worst)
      words += " (" + tradeoff.quantities[q].name + "), within " +
               limit_text(chosen.values[q], tradeoff.tolerance);
  return words + '.';
}

double widest_floor(const Tradeoff& tradeoff) {
  return std::max(kWidestFloor, tradeoff.tolerance);
}

/// Why nothing is recommended where seeds scatter too much, and how many would do.
std::string what_is_missing(const Tradeoff& tradeoff) {
  const double widest = widest_floor(tradeoff);
  std::string worst;
  double floor = 0;
  std::uint64_t seeds = 0;
  bool enough = true;
  for (std::size_t q = 0; q < tradeoff.quantities.size(); ++q) {
    const TradeoffQuantity& quantity = tradeoff.quantities[q];
    if (!quantity.decides || !(quantity.floor > widest)) continue;
    const auto values = values_of(tradeoff, q);
    const auto settings = static_cast<std::size_t>(
        std::count_if(values.begin(), values.end(), [](const auto& value) { return value.seeds > 0; }));
    const std::uint64_t needed =
        seeds_for(pooled_scatter(values, scale_of(tradeoff, quantity)), settings, widest, quantity.is_target);
    enough = enough && needed > 0;
    seeds = std::max(seeds, needed);
    if (!(quantity.floor > floor)) continue;
    floor = quantity.floor;
    worst = quantity.name;
  }
  std::string words = "No setting is recommended: the scatter over seeds is up to " +
                      percent_with_tenths_below_ten(floor) + " (" + worst +
                      "), and settings that differ by less than " + percent_with_tenths_below_ten(widest) +
                      " cannot be distinguished; ";
  return words + (enough
                      ? "about " + std::to_string(seeds) + " seeds of each would suffice: --seeds " +
                            std::to_string(seeds) + '.'
                      : "even a thousand seeds of each would not suffice: use finer grains or more powder.");
}

void recommend(Tradeoff& tradeoff, std::size_t reference) {
  if (!distinguishes_settings(tradeoff)) {
    tradeoff.advice = what_is_missing(tradeoff);
    return;
  }
  TradeoffPoint* chosen = nullptr;
  for (TradeoffPoint& point : tradeoff.points)
    if (is_acceptable(point) && has_enough_seeds(tradeoff, point) &&
        (chosen == nullptr || point.core_seconds < chosen->core_seconds))
      chosen = &point;
  if (chosen == nullptr) {
    tradeoff.advice = "No setting stays within the tolerance and the scatter over seeds.";
    return;
  }
  chosen->recommended = true;
  tradeoff.advice = advice_for(tradeoff, *chosen, tradeoff.points[reference]);
}

}  // namespace

PooledScatter pooled_scatter(const std::vector<TradeoffValue>& values, double scale) {
  PooledScatter pooled;
  double squares = 0;
  for (const TradeoffValue& value : values) {
    if (value.seeds < 2 || !std::isfinite(value.scatter)) continue;
    const double freedom = static_cast<double>(value.seeds - 1);
    squares += freedom * value.scatter * value.scatter;
    pooled.freedom += freedom;
  }
  pooled.scatter = pooled.freedom > 0 ? std::sqrt(squares / pooled.freedom) / scale : kNone;
  return pooled;
}

double error_floor(const PooledScatter& pooled, std::uint64_t seeds,
                   std::optional<std::uint64_t> of_reference) {
  if (!(pooled.freedom > 0) || !std::isfinite(pooled.scatter) || seeds == 0 || of_reference == 0U)
    return kNone;
  double inverse = 1 / static_cast<double>(seeds);
  if (of_reference) inverse += 1 / static_cast<double>(*of_reference);
  return results::student_95(pooled.freedom) * pooled.scatter * std::sqrt(inverse);
}

std::uint64_t seeds_for(const PooledScatter& pooled, std::size_t settings, double wanted, bool target) {
  constexpr std::uint64_t kMax = 1000;
  for (std::uint64_t seeds = 2; seeds <= kMax; ++seeds) {
    const double freedom = static_cast<double>(settings) * static_cast<double>(seeds - 1);
    const auto of_reference = target ? std::nullopt : std::optional(seeds);
    if (error_floor({pooled.scatter, freedom}, seeds, of_reference) <= wanted) return seeds;
  }
  return 0;
}

std::vector<std::size_t> pareto_front(const std::vector<double>& cost, const std::vector<double>& error) {
  std::vector<std::size_t> order;
  for (std::size_t k = 0; k < cost.size(); ++k)
    if (std::isfinite(cost[k]) && std::isfinite(error[k])) order.push_back(k);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return cost[a] != cost[b] ? cost[a] < cost[b] : error[a] < error[b];
  });
  std::vector<std::size_t> front;
  for (const std::size_t k : order)
    if (front.empty() || error[k] < error[front.back()]) front.push_back(k);
  return front;
}

std::size_t reference_setting(const std::vector<TradeoffPoint>& points, const std::vector<int>& finer) {
  std::size_t best = points.size();
  const auto better = [&](const TradeoffPoint& point) {
    if (best == points.size()) return true;
    const bool sound = point.reason.empty(), best_is_sound = points[best].reason.empty();
    return sound != best_is_sound ? sound : point.core_seconds > points[best].core_seconds;
  };
  for (std::size_t k = 0; k < points.size(); ++k)
    if (points[k].seeds > 0 && (points[k].changes.empty() || finer[k] > 0) && better(points[k])) best = k;
  return best;
}

bool is_acceptable(const TradeoffPoint& point) {
  return point.reason.empty() && std::isfinite(point.error) && point.beyond.empty();
}

bool has_enough_seeds(const Tradeoff& tradeoff, const TradeoffPoint& point) {
  if (point.reference) return true;
  for (std::size_t q = 0; q < point.values.size(); ++q)
    if (tradeoff.quantities[q].decides && point.values[q].floor > widest_floor(tradeoff)) return false;
  return true;
}

bool distinguishes_settings(const Tradeoff& tradeoff) {
  const double widest = widest_floor(tradeoff);
  return std::none_of(tradeoff.quantities.begin(), tradeoff.quantities.end(),
                      [&](const auto& quantity) { return quantity.decides && quantity.floor > widest; });
}

void evaluate(Tradeoff& tradeoff, std::size_t reference) {
  for (TradeoffPoint& point : tradeoff.points) point.reference = point.recommended = point.pareto = false;
  tradeoff.floor = kNone;
  if (reference >= tradeoff.points.size()) {
    tradeoff.advice = "No finished run is available as a reference.";
    return;
  }
  tradeoff.points[reference].reference = true;
  set_references(tradeoff, tradeoff.points[reference]);
  set_floors(tradeoff, tradeoff.points[reference]);
  std::vector<double> cost, error;
  for (TradeoffPoint& point : tradeoff.points) {
    set_errors(tradeoff, point);
    cost.push_back(point.core_seconds);
    error.push_back(point.reason.empty() ? point.error : kNone);  // what fails is no choice
  }
  for (const std::size_t k : pareto_front(cost, error)) tradeoff.points[k].pareto = true;
  recommend(tradeoff, reference);
}

}  // namespace diefill::process
