#include "process/estimate/statements/limits.h"
#include "process/estimate/statements/wording.h"
#include "process/estimate/trapped_air.h"
#include "process/results/formatted.h"
#include "process/results/rounding.h"

namespace diefill::process::estimate {

namespace {

std::string mass(double kilograms) {
  return results::mass_text(kilograms);
}

/// "cavity 2 at x = 12.5 mm, y = 0 mm: "
std::string heading(const Estimate& estimate, const OpeningEstimate& opening) {
  const std::string name = name_of(estimate, opening), article = "the ";
  return (name.starts_with(article) ? name.substr(article.size()) : name) + ": ";
}

std::string opening_text(const Estimate& estimate, const OpeningEstimate& opening) {
  const std::string crossings = times(opening.offered.size());
  std::string text = heading(estimate, opening);
  if (opening.is_cavity)
    text += results::formatted("%.3g cm3, %.3g mm deep, ", 1e6 * opening.volume, 1e3 * opening.depth);
  text += results::formatted("opening of %.3g mm2, %.3g mm wide on average", 1e6 * opening.area,
                             1e3 * opening.width);
  if (opening.effective_width < 0.99 * opening.width)
    text += results::formatted(", effective width %.3g mm for grains of %.3g mm",
                               1e3 * opening.effective_width, 1e3 * estimate.grain_diameter);
  if (opening.offered.empty()) return text + ". Powder never comes over it";
  const double in = opening.mass.back();
  if (opening.is_cavity && opening.poured >= kWhole)
    return text + ". Powder is poured over it while it is open: it is full when that rests, with " + mass(in);
  if (opening.runs_out()) text += ". Powder is poured over it while it is open and runs out before it rests";
  if (!opening.is_cavity)
    return text + ". " + mass(in) + " run through in " + crossings + ", " + mass(opening.least_mass) +
           " to " + mass(opening.most_mass);
  text += ". After " + crossings + " " + mass(in) + " of " + mass(opening.full_mass) +
          results::formatted(" are in it: %.0f %% full (%.0f to %.0f %%)", percent_up_to_full(opening.share),
                             percent_up_to_full(opening.least_share), percent_up_to_full(opening.most_share));
  if (opening.real_particle_share)
    text += results::formatted(
        "; with particles of the powder's own size, %.3g mm, %.0f %%, if the die is not widened for coarse "
        "grains",
        1e3 * *estimate.powder.particle_diameter, percent_up_to_full(*opening.real_particle_share));
  if (opening.too_fast > 0.05)
    text += results::formatted(". Over %.0f %% of the opening the shoe is too fast for flow to begin at all",
                               100 * opening.too_fast);
  return text;
}

void add_opening_statements(const Estimate& estimate, std::vector<Statement>& said) {
  for (const OpeningEstimate& opening : estimate.openings)
    said.push_back({"filling", opening_text(estimate, opening),
                    std::string(kFormula) +
                        "; inflow slows as the room above the powder shrinks (ours); law: " +
                        estimate.law.source + "; " + estimate.law.applies,
                    valid_text(estimate), error_text(estimate)});
  for (const std::string& cavity : estimate.unseen)
    said.push_back(
        {"filling",
         cavity + " was not seen from above: at the fill plane a tool covers it, or it is too narrow for "
                  "the places that are looked at; it is not estimated",
         "", "", "not measured"});
  const PowderEstimate& powder = estimate.powder;
  if (estimate.powder_limited)
    said.push_back({"powder",
                    "the shoe holds " + mass(powder.in_shoe) +
                        (powder.let_in > 0 ? ", and steps let in " + mass(powder.let_in) : "") +
                        ", less than would run in: pour deeper (pour.fill_height)",
                    "pour box times apparent density", "", "exact for the scene's apparent density"});
}

/// "critical shoe speed 0.064 m/s for one crossing, ..."
std::string critical_speed_text(const Estimate& estimate, const OpeningEstimate& opening) {
  std::string text =
      opening.speed_once
          ? results::formatted("critical shoe speed %.2g m/s for one crossing", *opening.speed_once)
      : opening.any_speed ? std::string("no critical shoe speed: it fills while the shoe stands over it")
                          : std::string("no critical shoe speed down to a hundredth of the scene's");
  if (opening.offered.size() > 1 && opening.speed_all)
    text += results::formatted(", %.2g m/s for %zu crossings", *opening.speed_all, opening.offered.size());
  text += with_grains(estimate.grain_diameter);
  if (opening.real_particle_speed_once)
    text +=
        results::formatted(" (%.2g m/s for one crossing with particles of the powder's own size, %.3g mm)",
                           *opening.real_particle_speed_once, 1e3 * *estimate.powder.particle_diameter);
  return text;
}

void add_speed_statements(const Estimate& estimate, std::vector<Statement>& said) {
  if (!(estimate.path.speed > 0)) return;
  for (const OpeningEstimate& opening : estimate.openings) {
    if (!opening.is_cavity || opening.offered.empty() || opening.poured >= kWhole) continue;
    std::string text = heading(estimate, opening) + critical_speed_text(estimate, opening);
    text += opening.crossings
                ? results::formatted("; at the scene's %.2g m/s it needs %d crossing%s", estimate.path.speed,
                                     *opening.crossings, *opening.crossings == 1 ? "" : "s")
                : results::formatted("; at the scene's %.2g m/s it does not fill in %d crossings",
                                     estimate.path.speed, kMaxCrossings);
    said.push_back({"shoe speed", text, kFormula, "as for filling; full means 99 %", error_text(estimate)});
  }
}

void add_outlet_statement(const Estimate& estimate, std::vector<Statement>& said) {
  if (!estimate.outlet) return;
  const bool round = estimate.outlet->round;
  said.push_back({"outlet", outlet_text(estimate),
                  round ? "Beverloo, Leniger, van de Velde 1961: 0.58 rho_a sqrt(g) (D - 1.4 d)^(5/2)"
                        : "Bierwisch 2009, Eq. 5.13; law: " + estimate.law.source,
                  "opening wider than six grains or so, powder much deeper than wide, free fall below",
                  "not measured; a factor of 2 either way is assumed"});
}

void add_powders_statement(const Estimate& estimate, std::vector<Statement>& said) {
  const std::string text = powders_text(estimate);
  if (!text.empty()) said.push_back({"powders", text, "", "", "not measured"});
}

/// One slow crossing against several quick ones.
void add_cycle_statement(const Estimate& estimate, std::vector<Statement>& said) {
  if (!estimate.cycle_time) return;
  std::string text = results::formatted("the scene's steps take %.3g s", *estimate.cycle_time);
  const OpeningEstimate* worst = emptiest(estimate);
  if (worst != nullptr && estimate.crossing && worst->speed_once && worst->crossings &&
      estimate.path.speed > 0) {
    const double many = *worst->crossings * estimate.crossing->time;
    const double slow = estimate.crossing->time_at(*worst->speed_once);
    if (*worst->crossings > 1)
      text += results::formatted(
          ". To fill %s, %d crossings at %.2g m/s take %.2g s and one at %.2g m/s %.2g s (pauses "
          "apart): %s is quicker",
          name_of(estimate, *worst).c_str(), *worst->crossings, estimate.path.speed, many, *worst->speed_once,
          slow, many < slow ? "passing often" : "one slow crossing");
    else if (*worst->speed_once > 1.1 * estimate.path.speed)
      text += results::formatted(". One crossing at %.2g m/s, which still fills %s, would save %.2g s",
                                 *worst->speed_once, name_of(estimate, *worst).c_str(),
                                 estimate.crossing->time - slow);
  }
  said.push_back({"cycle time", text, "the scene's motions", "powder rests at once", "not measured"});
}

/// What follows a falling punch by its own weight and, where that is known, by suction.
std::string following_text(const SuctionEstimate& suction) {
  constexpr double kNothing = 1e-3;  // of the room that the punch makes
  const double least = kNothing * suction.volume_mass, room = suction.covered * suction.volume_mass;
  const bool runs = suction.by_weight > least;
  const std::string text =
      runs ? mass(suction.by_weight) + " follow by their own weight" : "no powder runs in by its own weight";
  if (!suction.with_air) return text;
  if (const double more = *suction.with_air - suction.by_weight; more > least)
    return text + ", suction brings " + mass(more) + " more";
  if (!runs) return text + ", nor by suction";
  return text + (suction.by_weight >= room - least ? ", so suction brings nothing more while powder flows"
                                                   : ", and suction brings nothing more");
}

/// What the air that a punch draws does to powder at rest.
std::string pull_text(const SuctionEstimate& suction) {
  if (!suction.with_air || !suction.pull) return "; give --particle-diameter for what the air does";
  return results::formatted(
      "; the air it draws pulls at powder that stands still with %.2g of its weight%s", *suction.pull,
      *suction.pull > 1 ? ": enough to break bridges that carry no more than themselves"
                        : ": too little to break bridges, shake the shoe if it may arch");
}

std::string suction_text(const SuctionEstimate& suction) {
  std::string text = suction.punch.tool +
                     results::formatted(" falls %.3g mm at %.2g m/s and makes room for ",
                                        1e3 * suction.punch.stroke, suction.punch.speed()) +
                     mass(suction.volume_mass);
  if (!(suction.covered > 0)) return text + ", but no powder stands over it meanwhile";
  if (suction.covered < kWhole)
    text += results::formatted(", %.0f %% of it while powder stands over it", 100 * suction.covered);
  text += "; " + following_text(suction) + pull_text(suction);
  if (suction.may_arch)
    text +=
        ". Powder may arch over it: the opening is less than four grains wide, and nothing shakes the shoe";
  return text;
}

void add_suction_statements(const Estimate& estimate, std::vector<Statement>& said) {
  for (const SuctionEstimate& suction : estimate.suctions)
    said.push_back({"suction", suction_text(suction),
                    "rate of Eq. 5.13 with gravity and Darcy's drag (ours); Carman 1937",
                    "no leakage past the punch, which falls steadily", "not measured"});
}

std::string trapped_air_text(const PowderEstimate& powder, const OpeningEstimate& opening) {
  const double ratio = opening.air_ratio;
  const char* verdict =
      ratio < kAirSlows ? "air does not matter"
      : ratio < 1       ? "air slows the filling: expect less than the formulas say"
                  : "air limits filling: powder covering the whole opening cannot fall faster than the air "
                    "leaves; go slower, or let the punch fall under the shoe";
  return results::formatted(
             "its air needs %.2g s to escape through powder (%.2g m/s). Powder covers the whole opening for "
             "%.0f %% "
             "of the filling time and traps that share of the air, whose escape takes %.2g of that time "
             "(air slows "
             "the filling above %.1g): ",
             *opening.air_escapes, *powder.carrying_flux, 100 * opening.air_trapped, ratio, kAirSlows) +
         verdict;
}

void add_air_statements(const Estimate& estimate, std::vector<Statement>& said) {
  const PowderEstimate& powder = estimate.powder;
  if (!powder.air_number || !powder.carrying_flux) {
    said.push_back({"air", "unknown: give the size of the real particles with --particle-diameter '80 um'",
                    "", "", "not measured"});
    return;
  }
  const std::string particles =
      results::formatted("particles of %.3g mm, ", 1e3 * *powder.particle_diameter) + powder.particle_source;
  said.push_back(
      {"air",
       results::formatted("Archimedes number times density ratio %.2g (", *powder.air_number) + particles +
           "): it grows with the third power of the size and the second of the density; "
           "air slows powders with a small value",
       "Guo, Kafui, Wu, Thornton, Seville 2009, AIChE J. 55, 49",
       "orders powders; whether air slows this filling follows from the escape time", "not measured"});
  for (const OpeningEstimate& opening : estimate.openings)
    if (opening.air_escapes)
      said.push_back({"air", heading(estimate, opening) + trapped_air_text(powder, opening),
                      "Darcy 1856, permeability of Carman 1937",
                      "while powder covers the whole opening; grains of one size",
                      "not measured; the DEM has no air but in [suction]"});
}

}  // namespace

std::vector<Statement> statements(const Estimate& estimate) {
  std::vector<Statement> said;
  if (!estimate.is_estimated()) {
    said.push_back({"answer", answer_text(estimate), "", "", ""});
    add_cycle_statement(estimate, said);
    return said;
  }
  said.push_back({"answer", answer_text(estimate), kFormula, valid_text(estimate), error_text(estimate)});
  add_powders_statement(estimate, said);
  add_opening_statements(estimate, said);
  add_speed_statements(estimate, said);
  add_outlet_statement(estimate, said);
  add_cycle_statement(estimate, said);
  add_suction_statements(estimate, said);
  add_air_statements(estimate, said);
  return said;
}

}  // namespace diefill::process::estimate
