// Table of an experiment of the laboratory as text.
#pragma once

#include <string>

#include "process/results/studies/lab_table.h"

namespace diefill::app {

/// One line for each quantity: published, here with scatter, verdict, grain size, core seconds; reasons
/// below.
std::string lab_table_text(const results::LabTable& table);

}  // namespace diefill::app
