// What is stated of each discharge law holds for each, and tells it from the others.
#include "process/continuum/discharge_law.h"

#include <gtest/gtest.h>

#include <set>

namespace diefill::process::continuum {
namespace {

TEST(DischargeLaws, HaveNamesAndFormulasOfTheirOwn) {
  std::set<std::string> names, formulas;
  for (const DischargeLaw law : discharge_laws()) {
    names.insert(name_of(law));
    formulas.insert(formula_of(law));
  }
  EXPECT_EQ(names, (std::set<std::string>{"5.17", "5.18", "transient", "beverloo-round", "beverloo-slit"}));
  EXPECT_EQ(formulas.size(), names.size());
}

TEST(DischargeLaws, AreOfRatesOrOfMassesAsTheirFormulasAre) {
  for (const DischargeLaw law : discharge_laws()) {
    SCOPED_TRACE(name_of(law));
    const std::string formula = formula_of(law);
    EXPECT_EQ(is_of_rates(law), formula.starts_with("W = "));
    EXPECT_EQ(is_of_shoe(law), formula.find("v_s") != std::string::npos);
  }
}

}  // namespace
}  // namespace diefill::process::continuum
