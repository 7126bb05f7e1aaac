#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>

#include "process/estimate/estimate.h"
#include "process/results/rounding.h"

namespace diefill::process::estimate {

namespace {

constexpr const char* kFormula =
    "Bierwisch 2009, Eq. 5.17, on the local width of the opening (ours for shapes other than slits)";

/// Time that air needs to escape over the filling time, above which it slows the filling.
constexpr double kAirSlows = 0.3;

template <class... Numbers>
std::string line(const char* format, Numbers... numbers) {
  char text[600];
  std::snprintf(text, sizeof text, format, numbers...);
  return text;
}

std::string mass(double kilograms) {
  return results::mass_text(kilograms);
}

std::string times(std::size_t crossings) {
  return crossings == 1 ? "one crossing" : std::to_string(crossings) + " crossings";
}

double percent(double share) {
  return std::min(100.0, 100 * share);
}

/// Of what the cavity holds, floor or not.
double offered_share(const OpeningEstimate& opening) {
  return std::accumulate(opening.offered.begin(), opening.offered.end(), 0.0) / opening.full_mass;
}

std::string error_text(const Estimate& estimate) {
  const KnownError& error = estimate.error;
  if (!error.measured)
    return line("not measured for this powder; a factor of %.3g either way on the inflow is assumed",
                error.factor);
  return line("in 90 %% of cases a factor of at most %.3g on the inflow, and %.0f %% on the mass (",
              error.factor, 100 * error.packing) +
         error.source + ")";
}

std::string valid_text(const Estimate& estimate) {
  std::string text =
      "shoe speeds up to 5 sqrt(g D); powder at least 12 mm deep in the shoe; grains up to 0.43 of the width";
  if (std::isfinite(estimate.law.longest))
    text +=
        line("; flow times up to %.3g sqrt(D/g), beyond them at a constant rate", estimate.law.longest + 0.2);
  return text;
}

/// The opening that is emptiest, over what it holds.
const OpeningEstimate* emptiest(const Estimate& estimate) {
  const OpeningEstimate* worst = nullptr;
  for (const auto& opening : estimate.openings)
    if (opening.is_cavity && !opening.offered.empty() && (worst == nullptr || opening.share < worst->share))
      worst = &opening;
  return worst;
}

/// What to do where the shoe is too fast, or may be.
std::string remedy(const Estimate& estimate, const OpeningEstimate& opening) {
  std::string text;
  if (opening.speed_once) text = line("%.2g m/s fills it in one crossing", *opening.speed_once);
  if (opening.crossings && *opening.crossings > static_cast<int>(opening.offered.size()))
    text += (text.empty() ? "" : ", ") +
            line("%d crossings fill it at %.2g m/s", *opening.crossings, estimate.path.speed);
  if (text.empty()) text = "not even a hundredth of the speed fills it by this formula: widen the opening";
  return text;
}

/// "one crossing at 0.2 m/s", and whether that is more than one thing.
struct Subject {
  std::string words;
  bool several;
  std::string does(const char* verb) const { return words + ' ' + verb + (several ? "" : "s"); }
};

Subject subject(const Estimate& estimate, const OpeningEstimate& opening) {
  if (!(estimate.path.speed > 0)) return {"the shoe standing over it", false};
  return {times(opening.offered.size()) + line(" at %.3g m/s", estimate.path.speed),
          opening.offered.size() > 1};
}

/// Why there is no answer about a cavity; empty where there is one.
std::string no_answer(const Estimate& estimate, const OpeningEstimate* worst) {
  const bool runs_through = !estimate.openings.empty() && !estimate.openings.front().offered.empty();
  if (worst == nullptr)
    return runs_through ? "no cavity to be filled: the estimate gives the mass that runs through"
                        : "no shoe passes over an opening: there is nothing to estimate here; simulate";
  if (!(worst->effective_width > 0))
    return line(
        "grains of %.3g mm are too coarse for the %s, %.3g mm wide: 1.4 d of an opening stay empty, so "
        "that nothing runs in; take finer grains",
        1e3 * estimate.grain_diameter, worst->name.c_str(), 1e3 * worst->width);
  if (estimate.starved)
    return "the shoe holds less powder than the openings take: pour more, then estimate again";
  return {};
}

std::string answer_text(const Estimate& estimate) {
  const OpeningEstimate* worst = emptiest(estimate);
  const std::string none = no_answer(estimate, worst);
  if (!none.empty()) return none;
  const double least = percent(worst->least_share), most = percent(worst->most_share);
  const char* name = worst->name.c_str();
  const Subject passages = subject(estimate, *worst);
  if (estimate.answer == Answer::too_fast)
    return (estimate.path.speed > 0 ? "the shoe is too fast: " : "it does not fill: ") +
           passages.does("leave") +
           line(
               " the %s about %.0f %% full, at most %.0f %% with the uncertainty. No simulation is "
               "needed for this: ",
               name, percent(worst->share), most) +
           remedy(estimate, *worst);
  if (estimate.answer == Answer::fills)
    return passages.does("fill") +
           line(
               " every cavity: %.2g times what the %s holds would run in, and it is at "
               "least %.0f %% full with the uncertainty. No simulation is needed "
               "for this; simulate for the density map",
               offered_share(*worst), name, least);
  return "too close to call: " + passages.does("leave") +
         line(
             " the %s about %.0f %% full, %.0f to %.0f %% with the uncertainty. Simulate, or measure your "
             "powder (diefill fit-discharge); by the formula ",
             name, percent(worst->share), least, most) +
         remedy(estimate, *worst);
}

std::string opening_text(const Estimate& estimate, const OpeningEstimate& opening) {
  const std::string crossings = times(opening.offered.size());
  std::string text = opening.name + ": ";
  if (opening.is_cavity) text += line("%.3g cm3, %.3g mm deep, ", 1e6 * opening.volume, 1e3 * opening.depth);
  text += line("opening of %.3g mm2, %.3g mm wide on average", 1e6 * opening.area, 1e3 * opening.width);
  if (opening.effective_width < 0.99 * opening.width)
    text += line(", effective width %.3g mm for grains of %.3g mm", 1e3 * opening.effective_width,
                 1e3 * estimate.grain_diameter);
  if (opening.offered.empty()) return text + ". Powder never comes over it";
  const double in = opening.mass.back();
  if (!opening.is_cavity)
    return text + ". " + mass(in) + " run through in " + crossings + ", " + mass(opening.least_mass) +
           " to " + mass(opening.most_mass);
  text += ". After " + crossings + " " + mass(in) + " of " + mass(opening.full_mass) +
          line(" are in it: %.0f %% full (%.0f to %.0f %%)", percent(opening.share),
               percent(opening.least_share), percent(opening.most_share));
  if (opening.too_fast > 0.05)
    text += line(". Over %.0f %% of the opening the shoe is too fast for flow to begin at all",
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
  if (estimate.starved)
    said.push_back({"powder",
                    "the shoe holds " + mass(estimate.powder.in_shoe) +
                        ", less than would run in: pour deeper (pour.fill_height)",
                    "pour box times apparent density", "", "exact for the scene's apparent density"});
}

void add_speed_statements(const Estimate& estimate, std::vector<Statement>& said) {
  for (const OpeningEstimate& opening : estimate.openings) {
    if (!opening.is_cavity || opening.offered.empty()) continue;
    std::string text = opening.name + ": ";
    text += opening.speed_once ? line("critical shoe speed %.2g m/s for one crossing", *opening.speed_once)
                               : std::string(
                                     "no critical shoe speed within a hundredth to a hundred times "
                                     "the scene's");
    if (opening.offered.size() > 1 && opening.speed_all)
      text += line(", %.2g m/s for %zu crossings", *opening.speed_all, opening.offered.size());
    text += opening.crossings ? line("; at the scene's %.2g m/s it needs %d crossing%s", estimate.path.speed,
                                     *opening.crossings, *opening.crossings == 1 ? "" : "s")
                              : line("; at the scene's %.2g m/s it does not fill in %d crossings",
                                     estimate.path.speed, kMaxCrossings);
    said.push_back({"shoe speed", text, kFormula, "as for filling; full means 99 %", error_text(estimate)});
  }
}

/// One line for a scene of several powders; empty for one of a single powder.
std::string powders_text(const Estimate& estimate) {
  if (estimate.powder.left_out.empty()) return {};
  return "estimated as if all powder were " + estimate.powder.name + ": " + estimate.powder.left_out +
         " of [[other_powder]] is not taken into account";
}

void add_powders_statement(const Estimate& estimate, std::vector<Statement>& said) {
  const std::string text = powders_text(estimate);
  if (!text.empty()) said.push_back({"powders", text, "", "", "not measured"});
}

/// One slow crossing against several quick ones.
void add_cycle_statement(const Estimate& estimate, std::vector<Statement>& said) {
  if (!estimate.cycle_time) return;
  std::string text = line("the scene's steps take %.3g s", *estimate.cycle_time);
  const OpeningEstimate* worst = emptiest(estimate);
  if (worst != nullptr && estimate.crossing_time && worst->speed_once && worst->crossings &&
      estimate.path.speed > 0) {
    const double many = *worst->crossings * *estimate.crossing_time;
    const double slow = *estimate.crossing_time * estimate.path.speed / *worst->speed_once;
    if (*worst->crossings > 1)
      text += line(
          ". To fill the %s, %d crossings at %.2g m/s take %.2g s and one at %.2g m/s %.2g s (pauses "
          "apart): %s is quicker",
          worst->name.c_str(), *worst->crossings, estimate.path.speed, many, *worst->speed_once, slow,
          many < slow ? "passing often" : "one slow crossing");
    else if (*worst->speed_once > 1.1 * estimate.path.speed)
      text += line(". One crossing at %.2g m/s, which still fills the %s, would save %.2g s",
                   *worst->speed_once, worst->name.c_str(), *estimate.crossing_time - slow);
  }
  said.push_back({"cycle time", text, "the scene's motions", "powder rests at once", "not measured"});
}

void add_suction_statements(const Estimate& estimate, std::vector<Statement>& said) {
  for (const SuctionEstimate& suction : estimate.suctions) {
    std::string text = suction.punch.tool +
                       line(" falls %.3g mm at %.2g m/s and makes room for ", 1e3 * suction.punch.stroke,
                            suction.punch.speed()) +
                       mass(suction.volume_mass) + "; " + mass(suction.by_weight) +
                       " follow by their own weight";
    if (suction.with_air) {
      const double more = *suction.with_air - suction.by_weight;
      text += more > 1e-3 * suction.volume_mass ? ", suction brings " + mass(more) + " more"
                                                : ", so suction brings nothing more while powder flows";
      text += line("; the air it draws pulls at powder that stands still with %.2g of its weight%s",
                   *suction.pull,
                   *suction.pull > 1 ? ": enough to break bridges that carry no more than themselves"
                                     : ": too little to break bridges, shake the shoe if it may arch");
    } else {
      text += "; give --particle-diameter for what the air does";
    }
    said.push_back({"suction", text, "rate of Eq. 5.13 with gravity and Darcy's drag (ours); Carman 1937",
                    "no leakage past the punch, powder above it all the time", "not measured"});
  }
}

void add_air_statements(const Estimate& estimate, std::vector<Statement>& said) {
  const PowderEstimate& powder = estimate.powder;
  if (!powder.air_number || !powder.carrying_flux) {
    said.push_back({"air", "unknown: give the size of the real particles with --particle-diameter '80 um'",
                    "", "", "not measured"});
    return;
  }
  const std::string particles =
      line("particles of %.3g mm, ", 1e3 * *powder.particle_diameter) + powder.particle_source;
  said.push_back({"air",
                  line("Archimedes number times density ratio %.2g (", *powder.air_number) + particles +
                      "): it grows with the third power of the size and the second of the density; "
                      "air slows powders with a small value",
                  "Guo, Kafui, Wu, Thornton, Seville 2009, AIChE J. 55, 49",
                  "orders powders; whether air slows this filling follows from the escape time",
                  "not measured"});
  for (const OpeningEstimate& opening : estimate.openings) {
    if (!opening.air_escapes || !(opening.filling_time > 0)) continue;
    const double ratio = *opening.air_escapes / opening.filling_time;
    const char* verdict =
        ratio < kAirSlows ? "air does not matter"
        : ratio < 1       ? "air slows the filling: expect less than the formulas say"
                    : "air limits filling: powder covering the whole opening cannot fall faster than the air "
                      "leaves; go slower, or let the punch fall under the shoe";
    said.push_back(
        {"air",
         opening.name +
             line(": its air needs %.2g s to escape through powder (%.2g m/s), %.2g of the %.2g s "
                  "for which powder covers the opening (air slows the filling above %.1g): ",
                  *opening.air_escapes, *powder.carrying_flux, ratio, opening.filling_time, kAirSlows) +
             verdict,
         "Darcy 1856, permeability of Carman 1937",
         "while powder covers the whole opening; grains of "
         "one size",
         "not measured; the DEM has no air but in [suction]"});
  }
}

}  // namespace

std::vector<Statement> statements(const Estimate& estimate) {
  std::vector<Statement> said;
  said.push_back({"answer", answer_text(estimate), kFormula, valid_text(estimate), error_text(estimate)});
  add_powders_statement(estimate, said);
  add_opening_statements(estimate, said);
  add_speed_statements(estimate, said);
  add_cycle_statement(estimate, said);
  add_suction_statements(estimate, said);
  add_air_statements(estimate, said);
  return said;
}

std::vector<std::string> in_short(const Estimate& estimate) {
  std::vector<std::string> lines = {"estimate without simulation: " + answer_text(estimate)};
  const bool settled = estimate.answer == Answer::too_fast || estimate.answer == Answer::fills;
  if (settled)
    lines.push_back(std::string("the estimate alone shows that the cavity ") +
                    (estimate.answer == Answer::fills ? "fills" : "does not fill") +
                    ". Its error: " + error_text(estimate) + ". diefill estimate says more");
  if (!estimate.powder.left_out.empty()) lines.push_back(powders_text(estimate));
  return lines;
}

}  // namespace diefill::process::estimate
