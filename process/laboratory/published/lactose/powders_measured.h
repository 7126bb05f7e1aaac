// The two lactose powders as the source measured them, as it predicts them from its calibrated sets, and as
// these sets behave here, side by side.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "process/laboratory/published/published_figure.h"

namespace diefill::process::laboratory {

/// A section of FIDELITY.md; empty without figures of a calibrated set. `here` is the text of a figure's own
/// value and of its verdict.
std::string powders_measured(const std::vector<PublishedFigure>& figures,
                             const std::function<std::string(const PublishedFigure&)>& here);

}  // namespace diefill::process::laboratory
