// One run as numbers for the interactive view: grains at several instants, tools with their ways, the density
// field. Lengths in mm, the laboratory frame.
#pragma once

#include <QByteArray>
#include <QJsonObject>

#include "render/report/viewer/viewed_run.h"

namespace diefill::render::report {

/// How much of a run is packed.
struct PackingLimits {
  std::size_t spheres = 200000;    ///< shown at most
  std::size_t instants = 40;       ///< earlier ones at most; the end always comes on top
  std::size_t triangles = 400000;  ///< of one tool, which is left out beyond
};

/// `description`: names, frames, tools, and the table of arrays in `data` (PackedBytes::base64).
/// Frames differ from the one before, so that resting grains cost nothing: positions in 16 bits of the box
/// they need (65535: not there), no finer than 3 % of the smallest sphere's radius, orientations in 8 bits
/// a component, speeds as their logarithm in steps of 1 %, solid fractions as 1 + 5000 times the value in 16
/// bits (0: none).
struct PackedRun {
  QJsonObject description;
  QByteArray data;
};
PackedRun packed_run(const ViewedRun& run, const PackingLimits& limits);

}  // namespace diefill::render::report
