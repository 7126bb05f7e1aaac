// The filling as ParaView plays it: powder and tools at every kept instant, opened as one file.
#pragma once

#include <filesystem>
#include <functional>
#include <vector>

#include "process/results/fill_result.h"
#include "process/tooling/progress.h"
#include "render/scene3d/paraview_files.h"

namespace diefill::app {

/// What every grain knows of itself; open cells have no solid fraction and no stress.
std::vector<render::PointArray> grain_arrays(const results::FillResult& result);

/// Writes the fields of a result, whose solid fraction is measured, to a file.
using FieldWriter = std::function<void(const results::FillResult& then, const std::filesystem::path& file)>;

/// Writes the powder of every kept instant and of the end as powder_<n>.vtp into `folder`, each tool as
/// tool_<k>_<n>.vtp wherever it has moved since the instant before, and `series` (.pvd), which names them all
/// with their times: opened in ParaView, it shows powder and tools moving. With `fields` also fields_<n>.vti,
/// for which the solid fraction of every instant is measured. Returns what was written, `series`
/// last; nothing where the results hold no earlier instants. Throws as render::write_points() does.
std::vector<std::filesystem::path> write_filling_series(
    const results::FillResult& result, const std::filesystem::path& folder,
    const std::filesystem::path& series, const FieldWriter& fields = {},
    const process::ProgressCallback& on_progress = process::ignore_progress);

}  // namespace diefill::app
