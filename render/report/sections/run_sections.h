// Sections of a report on one run.
#pragma once

#include <vector>

#include "process/results/fill_result.h"
#include "render/report/document.h"
#include "render/report/pictures_of.h"

namespace diefill::render::report {

/// Results, pictures, strategy, tooling, powder and model, assumptions, stability, speed, versions and scene
/// of one run, with headings of `level`. `shared`: what its pictures have in common with the whole report.
std::vector<Section> run_sections(const results::FillResult& result, int level,
                                  const SharedPictures& shared = {});

}  // namespace diefill::render::report
