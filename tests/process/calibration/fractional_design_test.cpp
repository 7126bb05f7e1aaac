// Two-level designs: published ones row for row, resolution, aliases.
#include "process/calibration/methods/fractional_design.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>

#include "tests/process/calibration/published_designs.h"

namespace diefill::process::calibration {
namespace {

FractionalDesign screening_design() {
  return design_of(5, {"ABCDE", "ABC", "ABD", "ABE", "ACE", "ACD", "BCD"});
}

FractionalDesign calibration_design() {
  return design_of(5, {"ABC", "ABD", "BCDE"});
}

/// Places (row, column) where a printed table has not the value that the design asks for.
template <class Table>
std::set<std::pair<std::size_t, std::size_t>> deviations(
    const FractionalDesign& design, const Table& table,
    const std::vector<std::pair<double, double>>& low_high) {
  std::set<std::pair<std::size_t, std::size_t>> places;
  for (std::size_t run = 0; run < design.runs(); ++run)
    for (std::size_t k = 0; k < design.factors(); ++k) {
      const double wanted = level(design, run, k) > 0 ? low_high[k].second : low_high[k].first;
      if (table[run][k] != wanted) places.insert({run, k});
    }
  return places;
}

TEST(FractionalDesign, TheScreeningDesignOfTwelveFactorsIsAsPublishedRowForRow) {
  const auto design = screening_design();
  ASSERT_EQ(design.runs(), 32U);
  ASSERT_EQ(design.factors(), 12U);
  const auto places = deviations(design, kTable17,
                                 {{10, 150},
                                  {5, 50},
                                  {0.1, 0.3},
                                  {0.5, 1},
                                  {10, 50},
                                  {2, 20},
                                  {0.5, 5},
                                  {0.2, 1},
                                  {0.5, 0.8},
                                  {0.2, 1},
                                  {0.02, 0.2},
                                  {0.02, 0.2}});
  EXPECT_TRUE(places.empty());
}

TEST(FractionalDesign, TheCalibrationDesignOfEightFactorsIsAsPublishedButForItsFourSlips) {
  const auto design = calibration_design();
  ASSERT_EQ(design.runs(), 32U);
  const std::vector<std::pair<double, double>> low_high = {{10, 100},   {2, 20}, {0.5, 1.2},  {10, 50},
                                                           {0.02, 0.2}, {5, 50}, {0.03, 0.3}, {0.03, 0.3}};
  constexpr std::size_t kRolling = 6, kCohesion = 7;
  // Columns of the table: A_H, f1, mu_s, Y, phi_f, r, mu_r, f2.
  std::array<std::array<double, 8>, 32> table{};
  for (std::size_t run = 0; run < 32; ++run) table[run] = kTable18[run];
  const std::set<std::pair<std::size_t, std::size_t>> slips = {
      {8, kRolling}, {9, kRolling}, {10, kRolling}, {11, kRolling}, {9, kCohesion}, {11, kCohesion}};
  EXPECT_EQ(deviations(design, table, low_high), slips);
  // The rolling coefficients of these rows are those of Table 17; taken as levels, two rows have them
  // exchanged with f2.
  for (const std::size_t run : {8U, 9U, 10U, 11U}) {
    table[run][kRolling] = table[run][kRolling] == 0.02 ? 0.03 : 0.3;
    if (run % 2 == 1) std::swap(table[run][kRolling], table[run][kCohesion]);
  }
  EXPECT_TRUE(deviations(design, table, low_high).empty());
}

TEST(FractionalDesign, ThePublishedDefiningRelationsComeOut) {
  const auto words = defining_words(screening_design());
  ASSERT_EQ(words.size(), 127U);
  std::map<std::size_t, int> lengths;
  for (const auto& word : words) ++lengths[word.size()];
  EXPECT_EQ(lengths, (std::map<std::size_t, int>{{4, 38}, {6, 52}, {8, 33}, {10, 4}}));
  EXPECT_EQ(defining_words(calibration_design()),
            (std::vector<std::string>{"ABCF", "ABDG", "CDFG", "ACEGH", "ADEFH", "BCDEH", "BEFGH"}));
  EXPECT_EQ(resolution_of(screening_design()), 4U);
  EXPECT_EQ(resolution_of(calibration_design()), 4U);
  EXPECT_EQ(generators_of(calibration_design()),
            (std::vector<std::string>{"F = ABC", "G = ABD", "H = BCDE"}));
}

TEST(FractionalDesign, ThePublishedAliasStringsComeOut) {
  std::set<std::string> of_screening, of_calibration;
  std::size_t clear = 0;
  for (const auto& string : alias_strings(screening_design()))
    if (string.factors.empty()) of_screening.insert(text_of(string));
  const std::set<std::string> published = {
      "AB = CG = DH = EJ = LM", "AC = BG = DL = EK = HM", "AD = BH = CL = GM",      "AE = BJ = CK = FM",
      "AF = EM = HK = JL",      "AG = BC = DM = HL = JK", "AH = BD = CM = FK = GL", "AJ = BE = FL = GK",
      "AK = CE = FH = GJ",      "AL = BM = CD = FJ = GH", "AM = BL = CH = DG = EF", "BF = DK = EL = JM",
      "BK = CJ = DF = EG",      "CF = DJ = EH = KM",      "DE = FG = HJ = KL"};
  EXPECT_EQ(of_screening, published);
  for (const auto& string : alias_strings(calibration_design())) {
    if (!string.factors.empty()) {
      EXPECT_EQ(string.pairs.size(), 0U);  // resolution IV: main effects are clear of pairs
    } else if (string.pairs.size() > 1) {
      of_calibration.insert(text_of(string));
    } else {
      ++clear;
    }
  }
  EXPECT_EQ(of_calibration, (std::set<std::string>{"AB = CF = DG", "AC = BF", "AD = BG", "AF = BC", "AG = BD",
                                                   "CD = FG", "CG = DF"}));
  EXPECT_EQ(clear, 13U);
}

TEST(FractionalDesign, CompactDesignsHaveTheResolutionAskedForAndFewRuns) {
  // Fewest runs known for these numbers of factors (Box, Hunter and Hunter, Table 12.15).
  const std::map<std::size_t, std::map<std::size_t, std::size_t>> base = {
      {3, {{3, 2}, {5, 3}, {7, 3}, {8, 4}, {15, 4}, {16, 5}}},
      {4, {{4, 3}, {5, 4}, {8, 4}, {9, 5}, {12, 5}, {16, 5}, {17, 6}}},
      {5, {{3, 3}, {5, 4}, {6, 5}, {8, 6}, {9, 7}, {11, 7}}}};
  for (const auto& [resolution, factors] : base)
    for (const auto& [count, runs] : factors) {
      SCOPED_TRACE(std::to_string(count) + " factors, resolution " + std::to_string(resolution));
      const auto design = compact_design(count, resolution);
      EXPECT_EQ(design.factors(), count);
      EXPECT_EQ(design.base, runs);
      if (design.factors() > design.base) {
        EXPECT_GE(resolution_of(design), resolution);
      }
    }
}

TEST(FractionalDesign, ColumnsAreBalancedAndOrthogonalForManyFactors) {
  const auto design = compact_design(40, 4);
  EXPECT_EQ(design.runs(), 128U);
  EXPECT_EQ(resolution_of(design), 4U);  // too many words to write out: by the shortest
  for (std::size_t a = 0; a < design.factors(); ++a) {
    int sum = 0;
    for (std::size_t run = 0; run < design.runs(); ++run) sum += level(design, run, a);
    EXPECT_EQ(sum, 0);
    for (std::size_t b = 0; b < a; ++b) {
      int product = 0;
      for (std::size_t run = 0; run < design.runs(); ++run)
        product += level(design, run, a) * level(design, run, b);
      EXPECT_EQ(product, 0) << a << ' ' << b;
    }
  }
}

TEST(FractionalDesign, AFullFactorialHasNoWords) {
  const auto design = compact_design(2, 5);
  EXPECT_EQ(design.runs(), 4U);
  EXPECT_EQ(resolution_of(design), 0U);
  EXPECT_TRUE(defining_words(design).empty());
}

TEST(FractionalDesign, LettersLeaveOutTheIdentityAndGoOn) {
  EXPECT_EQ(factor_letter(0), "A");
  EXPECT_EQ(factor_letter(7), "H");
  EXPECT_EQ(factor_letter(8), "J");
  EXPECT_EQ(factor_letter(24), "Z");
  EXPECT_EQ(factor_letter(25), "a");
  EXPECT_EQ(factor_letter(50), "A2");
  std::set<std::string> letters;
  for (std::size_t k = 0; k < 200; ++k) EXPECT_TRUE(letters.insert(factor_letter(k)).second);
}

TEST(FractionalDesign, BadGeneratorsAndSizesAreRefused) {
  EXPECT_THROW(design_of(3, {"ABD"}), std::invalid_argument);
  EXPECT_THROW(design_of(3, {"ABA"}), std::invalid_argument);
  EXPECT_THROW(design_of(3, {"A"}), std::invalid_argument);
  EXPECT_THROW(design_of(3, {"AB", "AB"}), std::invalid_argument);
  EXPECT_THROW(design_of(0, {}), std::invalid_argument);
  EXPECT_THROW(compact_design(0, 4), std::invalid_argument);
  EXPECT_THROW(compact_design(4, 6), std::invalid_argument);
}

}  // namespace
}  // namespace diefill::process::calibration
