// Two-level fractional factorial designs: which combinations of high and low levels to run, and which effects
// such a design cannot separate (Box, Hunter and Hunter, Statistics for Experimenters; Kottlan 2018,
// section 2.5.1).
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace diefill::process::calibration {

/// A 2^(n-p) design. Its base factors take all combinations of levels; every other factor has the product of
/// the levels of some of them.
struct FractionalDesign {
  std::size_t base = 0;  ///< number of base factors, which come first
  /// One a factor: the base factors that its levels are the product of, bit k for base factor k.
  std::vector<std::uint64_t> columns;

  std::size_t factors() const { return columns.size(); }
  std::size_t runs() const { return std::size_t{1} << base; }
};

using FactorPair = std::pair<std::size_t, std::size_t>;

/// Letter of a factor, from 0: A to Z without I, which stands for the identity, then a to z without i, then
/// A2, B2 and so on.
std::string factor_letter(std::size_t factor);

/// The design of `base` factors and one more for each generator, such as "ABC": the base factors whose
/// product it is. Throws std::invalid_argument for letters that are none of the base factors' and for words
/// given twice.
FractionalDesign design_of(std::size_t base, const std::vector<std::string>& generators);

/// A design with few runs of at least this resolution (3 to 5), generators of few letters first. Throws
/// std::invalid_argument for no factors, for other resolutions, and where 2^16 runs are too few.
FractionalDesign compact_design(std::size_t factors, std::size_t resolution);

/// +1 or -1, the product of the levels of a column's base factors. Runs are in the order of Kottlan 2018,
/// Tables 17 and 18: from all high to all low, the last base factor changing from run to run.
int level_of_column(const FractionalDesign& design, std::size_t run, std::uint64_t column);
int level(const FractionalDesign& design, std::size_t run, std::size_t factor);

/// Length of the shortest word of the defining relation; 0 for a full factorial, which has none.
std::size_t resolution_of(const FractionalDesign& design);

/// Such as "F = ABC", one for each factor that is none of the base.
std::vector<std::string> generators_of(const FractionalDesign& design);

/// All words of the defining relation, short ones first. Throws std::invalid_argument for more than 20
/// generators.
std::vector<std::string> defining_words(const FractionalDesign& design);

/// Effects that the design cannot separate: what it measures is their sum.
struct AliasString {
  std::uint64_t column = 0;
  std::vector<std::size_t> factors;  ///< main effects in it
  std::vector<FactorPair> pairs;     ///< interactions of two factors in it
};

/// All strings with a main effect or a pair in them, those of the factors first, then by their first pair.
std::vector<AliasString> alias_strings(const FractionalDesign& design);

/// Such as "AB = CF = DG".
std::string text_of(const AliasString& string);

}  // namespace diefill::process::calibration
