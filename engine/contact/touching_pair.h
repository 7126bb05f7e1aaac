// A touching pair of grains on its way from the pair table into a batch.
#pragma once

#include "engine/search/pair_table.h"

namespace diefill::engine {

/// A touching pair, and where the table has what it remembered before this step.
struct TouchingPair {
  GrainPair pair;
  std::uint32_t history;
};

}  // namespace diefill::engine
