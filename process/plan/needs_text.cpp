#include <algorithm>
#include <cmath>

#include "process/plan/needs.h"
#include "process/plan/setting.h"
#include "process/results/formatted.h"
#include "process/scene/contact/contact_spec.h"

namespace diefill::process::plan {

namespace {

constexpr double kAtLimit = 0.99;  // share of a limit from which that limit sets the step

void add_width_statement(const Needs& needs, std::vector<std::string>& lines) {
  const auto& cavity = needs.cavity;
  const double d = 1e3 * needs.grain_diameter;
  if (!(needs.coarsest_grain > 0)) {
    lines.push_back(results::formatted(
        "width: no cavity below the fill plane, so the largest allowable grain is unknown; keep d (%.4g "
        "mm) below a third of the narrowest opening",
        d));
    return;
  }
  const Eigen::Vector3d place = 1e3 * cavity.narrowest_place;
  lines.push_back(results::formatted(
      "width: the cavity is narrowest, %.3f mm, near (%.2f, %.2f, %.2f) mm; a reliable density map "
      "needs d of at most a third of it, %.4g mm; here d is %.4g mm, %.2f of it",
      1e3 * cavity.narrowest_width, place[0], place[1], place[2], 1e3 * needs.coarsest_grain, d,
      needs.grain_diameter / cavity.narrowest_width));
  if (needs.grain_diameter > needs.calibrated_diameter * (1 + 1e-9))
    lines.push_back(results::formatted(
        "effective width: for grains of %.4g mm instead of %.4g mm an opening acts narrower by 1.4 "
        "times the difference: %.3f mm acts like %.3f mm (Bierwisch 2009, section 3.2.2); a ring drawn "
        "b0 + 1.4 d wide compensates for it",
        d, 1e3 * needs.calibrated_diameter, 1e3 * cavity.narrowest_width, 1e3 * needs.effective_width));
}

void add_step_statement(const Needs& needs, const Scene& scene, std::vector<std::string>& lines) {
  const double share = needs.time_step / needs.critical_step;
  lines.push_back(results::formatted(
      "time step: %.3g s, %.2f of the critical %.3g s at collisions of %.2g m/s; undamped grains gain "
      "energy from 0.49 of it on, a step %.1f times as long (engine/STABILITY.md)",
      needs.time_step, share, needs.critical_step, needs.impact_speed, 0.49 / share));
  if (needs.time_step > needs.wedged_step * (1 + 1e-9))
    lines.push_back(results::formatted(
        "time step: longer than the %.3g s up to which grains wedged by moving tools stay stable: such "
        "grains are sheared off sooner, and if there are many the run stops; remove the time step from "
        "the scene or reduce it",
        needs.wedged_step));
  else if (needs.time_step > kAtLimit * needs.wedged_step)
    lines.push_back(
        std::string("time step: limited by grains wedged by moving tools") +
        (scene.walls.kind == WallKind::mesh
             ? ""
             : "; these touch many wall spheres at once: larger wall spheres (walls.sphere_radius) or the "
               "CAD mesh itself (walls.kind = \"mesh\") allow longer steps"));
}

/// What the pressures on the powder require of E~.
std::string modulus_text(const Needs& needs) {
  if (!(needs.least_modulus > 0))
    return ", and no piston presses: this requires no least E~; the run reports overlaps above 0.2 of the "
           "sphere radius";
  const std::string verdict =
      needs.modulus >= needs.least_modulus
          ? results::formatted("%.3g MPa is %.1f times that", 1e-6 * needs.modulus,
                               needs.modulus / needs.least_modulus)
          : results::formatted("%.3g MPa is too soft: raise powder.reduced_modulus", 1e-6 * needs.modulus);
  return results::formatted(", which requires E~ of %.3g MPa (3000 times as much); ",
                            1e-6 * needs.least_modulus) +
         verdict;
}

void add_stiffness_statement(const Needs& needs, const Scene& scene, std::vector<std::string>& lines) {
  const std::string piston = needs.piston_pressure > 0 ? results::formatted(" and %.3g kPa under the piston",
                                                                            1e-3 * needs.piston_pressure)
                                                       : "";
  const std::string pressure = results::formatted(
      "stiffness: the weight of the powder exerts at most %.3g kPa", 1e-3 * needs.weight_pressure);
  if (scene.contact) {
    lines.push_back(pressure + piston +
                    "; [contact] sets the spring: the run reports overlaps above 0.2 of the sphere radius");
    return;
  }
  lines.push_back(pressure + piston + modulus_text(needs));
  if (needs.damping_over_radius > kMaxDamping)
    lines.push_back(results::formatted(
        "damping: gamma_n / R of %.2g Pa s/m is above 3e6, where it only shortens the time step; reduce "
        "powder.damping_over_radius",
        needs.damping_over_radius));
}

void add_walls_statement(const Scene& scene, const Tooling& tooling, std::vector<std::string>& lines) {
  std::string each;
  for (const Tool& tool : tooling.tools)
    each += (each.empty() ? "" : ", ") + tool.spec.name + " " + std::to_string(tool.spheres.centres.size());
  const bool all = !scene.economy.skip_far_walls;
  lines.push_back("walls: " + std::to_string(tooling.wall_spheres()) + " wall spheres " +
                  (all ? "on all surfaces (" : "where powder can reach (") + each + ")" +
                  results::formatted(", radius %.3g mm, spacing %.2g radii; ",
                                     1e3 * scene.walls.sphere_radius, scene.walls.spacing) +
                  (all ? "economy.skip_far_walls would save those that powder cannot reach"
                       : "surfaces that powder cannot reach have none"));
}

void add_powder_statement(const Needs& needs, const Scene& scene, std::vector<std::string>& lines) {
  const Eigen::Vector3d size = scene.pour.upper - scene.pour.lower;
  const double takes = needs.cavity.found ? needs.cavity.volume / (size[0] * size[1]) : 0;
  const double left = needs.fill_height - takes;
  const char* verdict = left >= kEnoughPowder
                            ? "deep enough: depth has no effect above 19 mm"
                            : "shallow: discharge at 10 mm differed from that at 19 and 41 mm";
  lines.push_back(results::formatted("powder height: %.4g mm in the shoe, %.3g mm when the cavity is full; ",
                                     1e3 * needs.fill_height, 1e3 * left) +
                  verdict + " (Bierwisch 2009, section 4.1.6, slit of 6 mm, model D2)");
}

void add_symmetry_statement(const Needs& needs, std::vector<std::string>& lines) {
  if (needs.planes.empty())
    lines.push_back("symmetry: the tools have no common vertical mirror plane across x or y");
  for (const auto& plane : needs.planes) {
    const char axis = std::abs(plane.normal[0]) > 0.5 ? 'x' : 'y';
    const std::string where = results::formatted("symmetry: the tools are mirror images across %c = %.3g mm",
                                                 axis, std::round(1e6 * plane.offset) / 1e3 + 0.0);
    lines.push_back(
        where +
        (plane.asymmetry.empty()
             ? ", and so are powder and motion: a half model is possible (economy.mirror; verify it first)"
             : ", but not " + plane.asymmetry));
  }
}

/// Steps whose `until` may end them before their duration is over, such as "step.2 (press)".
std::string steps_that_may_end_earlier(const Scene& scene) {
  std::string names;
  for (std::size_t k = 0; k < scene.steps.size(); ++k) {
    const Step& step = *scene.steps[k];
    if (!step.plan.until || step.open_ended() || !step.duration()) continue;
    names += (names.empty() ? "step." : ", step.") + std::to_string(k + 1);
    if (!step.plan.name.empty()) names += " (" + step.plan.name + ")";
  }
  return names;
}

void add_length_statement(const Scene& scene, std::vector<std::string>& lines) {
  const std::string names = steps_that_may_end_earlier(scene);
  if (!names.empty())
    lines.push_back("simulated time: the longest possible of " + names +
                    ", which `until` may end earlier; time and steps below are upper limits in this respect");
}

}  // namespace

std::vector<std::string> description(const Needs& needs, const Scene& scene, const Tooling& tooling) {
  std::vector<std::string> lines;
  add_width_statement(needs, lines);
  add_step_statement(needs, scene, lines);
  add_stiffness_statement(needs, scene, lines);
  add_walls_statement(scene, tooling, lines);
  add_powder_statement(needs, scene, lines);
  add_symmetry_statement(needs, lines);
  add_length_statement(scene, lines);
  lines.push_back("laws in use: " + joined(needs.laws.used));
  lines.push_back("omitted laws (zero coefficient): " + joined(needs.laws.left_out));
  return lines;
}

}  // namespace diefill::process::plan
