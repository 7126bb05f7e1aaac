#include "process/results/field_value.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "process/results/none.h"
#include "process/results/places_without_value.h"

namespace diefill::results {
namespace {

constexpr double kTurn = 360;  // deg

/// The nodes on both sides of a place, and the share of the way from the first to the second.
struct Neighbours {
  std::size_t below = 0, above = 0;
  double share = 0;
};

bool is_round(const std::string& name, const std::string& unit) {
  return name == "azimuth" && unit == "deg";
}

/// `x` by whole turns into `start` to `start` + 360.
double within_turn(double x, double start) {
  const double past = std::fmod(x - start, kTurn);
  return start + (past < 0 ? past + kTurn : past);
}

/// Neighbours of `x` among rising nodes; none beyond them.
std::optional<Neighbours> neighbours(const std::vector<double>& nodes, double x, bool round) {
  if (nodes.empty() || !std::isfinite(x)) return std::nullopt;
  const double first = nodes.front(), last = nodes.back();
  if (round && (x < first || x > last)) {
    x = within_turn(x, first);
    if (x > last) return Neighbours{nodes.size() - 1, 0, (x - last) / (first + kTurn - last)};
  }
  if (x < first || x > last) return std::nullopt;
  const auto next = std::upper_bound(nodes.begin(), nodes.end(), x);
  if (next == nodes.end()) return Neighbours{nodes.size() - 1, nodes.size() - 1, 0};
  const auto above = static_cast<std::size_t>(next - nodes.begin());
  return Neighbours{above - 1, above, (x - nodes[above - 1]) / (nodes[above] - nodes[above - 1])};
}

}  // namespace

double value_at(const Profile& profile, double x) {
  const auto at = neighbours(profile.x, x, is_round(profile.x_name, profile.x_unit));
  if (!at) return kNone;
  // A node without a value counts only where it has a share.
  if (at->share == 0) return profile.y[at->below];
  return (1 - at->share) * profile.y[at->below] + at->share * profile.y[at->above];
}

double value_at(const Field2D& field, double first, double second) {
  const auto column = neighbours(field.first, first, is_round(field.first_name, field.first_unit)),
             row = neighbours(field.second, second, is_round(field.second_name, field.second_unit));
  if (field.value.empty() || !column || !row) return kNone;
  const std::size_t columns[] = {column->below, column->above}, rows[] = {row->below, row->above};
  const double right = column->share, up = row->share;
  const double weights[2][2] = {{(1 - up) * (1 - right), (1 - up) * right}, {up * (1 - right), up * right}};
  double sum = 0;
  bool unvalued = false;
  for (std::size_t b = 0; b < 2; ++b)
    for (std::size_t a = 0; a < 2; ++a) {
      if (!(weights[b][a] > 0)) continue;
      const double value = field.value[rows[b] * field.first.size() + columns[a]];
      if (is_unvalued_powder(value))
        unvalued = true;
      else
        sum += weights[b][a] * value;
    }
  return unvalued && !std::isnan(sum) ? unvalued_powder() : sum;
}

}  // namespace diefill::results
