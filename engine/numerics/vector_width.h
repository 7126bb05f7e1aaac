// Loops in two forms: with vectors of four numbers where a register holds them, and number by number where
// shuffling such vectors would take longer.
#pragma once

#include <type_traits>

#include "engine/numerics/vector_instructions.h"

namespace diefill::engine {

/// As with_instructions(), calling work(true_type) where a register holds four numbers, and work(false_type)
/// elsewhere. Both forms must give the same bits.
template <class Work>
void with_width(InstructionSet set, const Work& work) {
#if defined(__x86_64__)
  if (set == InstructionSet::avx512) return instructions::avx512([&] { work(std::true_type{}); });
  if (set == InstructionSet::avx2) return instructions::avx2([&] { work(std::true_type{}); });
#endif
  instructions::baseline([&] { work(std::false_type{}); });
}

}  // namespace diefill::engine
