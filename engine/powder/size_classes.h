// A size distribution cut into a number of classes, each of which becomes a particle type.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/powder/size_distribution.h"

namespace diefill::engine {

/// One class: the diameter that stands for all of it, and how many grains have it.
struct CutClass {
  double diameter = 0;      ///< m, that of the mean mass of the class
  double number_share = 0;  ///< of all grains; shares add up to 1
};

/// The distribution in at most `count` classes, ascending. A discrete one keeps its own classes. A log-normal
/// one is cut into classes of equal width in ln d between the diameter below which 0.1 % of the grains lie
/// and that above which 0.1 % of the mass lies, or its cut-offs; the classes at both ends take in what lies
/// beyond. Number and mass of every class are exact, so that those of the whole are; other moments approach
/// theirs with the square of the class width. Throws std::invalid_argument for a discrete distribution of
/// more classes than `count`, or a count of 0.
std::vector<CutClass> size_classes(const SizeDistribution& distribution, std::size_t count);

/// How many of `grains` grains belong to each class: as near to the shares as whole numbers come (largest
/// remainders), so that small samples keep the mass of the distribution.
std::vector<std::size_t> class_counts(const std::vector<CutClass>& classes, std::size_t grains);

/// The class of each of `grains` grains, class_counts() of each in an order drawn from `seed`: the same on
/// every machine.
std::vector<std::uint16_t> drawn_classes(const std::vector<CutClass>& classes, std::size_t grains,
                                         std::uint64_t seed);

}  // namespace diefill::engine
