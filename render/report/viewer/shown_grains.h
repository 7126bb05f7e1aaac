// Which grains an interactive view shows: all where there are few enough, otherwise a part of them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "process/results/fill_result.h"

namespace diefill::render::report {

/// Identities in rising order, with what is constant over a grain's life.
struct ShownGrains {
  std::vector<std::uint64_t> id;
  std::vector<std::uint8_t> kind;       ///< its number in ParticleTypes; 0 for powder of one size
  std::vector<std::uint8_t> in_cavity;  ///< 1: its centre lies in the cavity at the end
  std::size_t spheres = 0;              ///< of the grains shown
  std::string remark;                   ///< for people, where some are left out; otherwise empty
};

/// Grains of the end and of the kept instants at `instants`. Beyond `most` spheres in all, grains that end in
/// the cavity are kept before others, and of each of the two groups an even share by identity.
ShownGrains shown_grains(const results::FillResult& result, const std::vector<std::size_t>& instants,
                         std::size_t most);

}  // namespace diefill::render::report
