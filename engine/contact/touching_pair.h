// A touching pair of grains, as the pair loop lists it between pair table and batch.
#pragma once

#include "engine/search/pair_table.h"

namespace diefill::engine {

/// A touching pair, and where the table has its history before this step.
struct TouchingPair {
  GrainPair pair;
  std::uint32_t history;
};

}  // namespace diefill::engine
