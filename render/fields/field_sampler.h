// A field between its nodes: bilinear where there are values, with the edges of holes kept at the nodes'
// cells.
#pragma once

#include <array>

#include "process/results/fill_result.h"
#include "render/style/ticks.h"

namespace diefill::render {

/// Whether the field's first coordinate is an azimuth in degrees, which comes round again after 360.
bool has_azimuth(const results::Field2D& field);

/// Throws std::runtime_error, naming the field, where coordinates are not finite and rising, there are fewer
/// than two along either, or their number does not match the values.
void check_field(const results::Field2D& field);

/// The field with its azimuth continued beyond 0 and 360 deg by one node each; other fields unchanged.
results::Field2D continued_round(const results::Field2D& field);

/// Reads a field at any place between its nodes.
class FieldSampler {
 public:
  /// `field` must outlive the sampler.
  explicit FieldSampler(const results::Field2D& field);

  /// Value at (first, second) in the field's units, clamped to the grid. Next to a hole only the
  /// corners with values count; where those weigh less than half, what weighs most of what
  /// places_without_value.h knows.
  double at(double first, double second) const;
  /// The same at a place that is known to lie outside tools: corners in them do not count, unless all are.
  double at_outside_tools(double first, double second) const;

 private:
  struct Corners {
    std::array<double, 4> values, weights;
  };
  Corners corners_of(double first, double second) const;
  static double mean_of(const Corners& corners);

  const results::Field2D& field_;
};

}  // namespace diefill::render
