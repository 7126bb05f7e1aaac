// The grains of a run at several instants as small differences.
#pragma once

#include <QJsonArray>
#include <QJsonObject>

#include "render/report/viewer/packed_bytes.h"
#include "render/report/viewer/shown_grains.h"
#include "render/report/viewer/viewed_run.h"

namespace diefill::render::report {

/// Packs the shown grains at the kept instants and at the end. Returns `box` (lower corner and step of a
/// coordinate, mm) and `frames`: of each its time (s) and the pose of every tool (quaternion w, x, y, z, then
/// displacement in mm).
QJsonObject pack_frames(PackedBytes& bytes, const ViewedRun& run, const std::vector<std::size_t>& instants,
                        const ShownGrains& shown);

}  // namespace diefill::render::report
