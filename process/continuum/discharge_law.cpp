#include "process/continuum/discharge_law.h"

#include <algorithm>
#include <array>

namespace diefill::process::continuum {

namespace {

enum class Measured { shoe_masses, masses_over_time, rates };

struct LawFacts {
  DischargeLaw law;
  const char* name;
  Measured measured;
  const char* formula;
};

constexpr std::array kLawFacts = {
    LawFacts{DischargeLaw::moving_shoe, "5.17", Measured::shoe_masses,
             "m = rho_a D b l [C_B + C_F (x + (1 - C_I/C_F)/beta (exp(-beta x) - 1))], x = sqrt(gD)/v_s - "
             "1/5 (Bierwisch 2009, Eqs. 4.1, 5.17)"},
    LawFacts{DischargeLaw::power_law, "5.18", Measured::shoe_masses,
             "m = C_S rho_a D b l (sqrt(gD)/v_s)^(1 + n) (Bierwisch 2009, Eq. 5.18)"},
    LawFacts{DischargeLaw::transient, "transient", Measured::masses_over_time,
             "m(t) = rho_a b D^2 [C_B + C_F (x + (1 - C_I/C_F)/beta (exp(-beta x) - 1))], x = t sqrt(g/D) - "
             "1/5 (integral of Bierwisch 2009, Eq. 5.15)"},
    LawFacts{DischargeLaw::beverloo_round, "beverloo-round", Measured::rates,
             "W = C rho_a sqrt(g) (D - k d)^(5/2) (Beverloo 1961; Bierwisch 2009, Eq. 5.1)"},
    LawFacts{DischargeLaw::beverloo_slit, "beverloo-slit", Measured::rates,
             "W = C rho_a b sqrt(g) (D - k d)^(3/2) (Beverloo for a slit; Bierwisch 2009, Eq. 5.13)"},
};

constexpr auto kDischargeLaws = [] {
  std::array<DischargeLaw, kLawFacts.size()> laws{};
  std::transform(kLawFacts.begin(), kLawFacts.end(), laws.begin(),
                 [](const LawFacts& facts) { return facts.law; });
  return laws;
}();

const LawFacts& facts_of(DischargeLaw law) {
  return *std::find_if(kLawFacts.begin(), kLawFacts.end(),
                       [&](const LawFacts& facts) { return facts.law == law; });
}

}  // namespace

std::span<const DischargeLaw> discharge_laws() {
  return kDischargeLaws;
}

std::string name_of(DischargeLaw law) {
  return facts_of(law).name;
}

std::string formula_of(DischargeLaw law) {
  return facts_of(law).formula;
}

bool is_of_rates(DischargeLaw law) {
  return facts_of(law).measured == Measured::rates;
}

bool is_of_shoe(DischargeLaw law) {
  return facts_of(law).measured == Measured::shoe_masses;
}

}  // namespace diefill::process::continuum
