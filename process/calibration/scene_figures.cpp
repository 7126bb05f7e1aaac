#include "process/calibration/scene_figures.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace diefill::process::calibration {
namespace {

bool has_several_sizes(const Scene& scene) {
  return smallest_grain(scene) < largest_grain(scene);
}

bool has_several_powders(const Scene& scene) {
  return !scene.other_powders.empty();
}

/// What figures with `part` in their name need of the powder; the first that is met counts.
struct PowderRule {
  std::string_view part;
  bool (*met)(const Scene&);
  const char* otherwise;
};

constexpr std::array<PowderRule, 3> kPowderRules = {
    {{"powder_mixing_index", has_several_powders,
      "the scene has one powder, and this needs an [[other_powder]]"},
     {"first_powder_mass_share", has_several_powders,
      "the scene has one powder, and this needs an [[other_powder]]"},
     {"mixing_index", has_several_sizes,
      "all grains have one size, and this needs several: give [powder.sizes]"}}};

bool has_a_die(const Scene& scene) {
  return std::any_of(scene.tools.begin(), scene.tools.end(),
                     [](const ToolSpec& tool) { return tool.role == ToolRole::die; });
}

enum class Shape { any, ring, no_ring };

/// Shapes of cavities that give figures with `part` in their name a value; the first that is met counts.
struct CavityRule {
  std::string_view part;
  Shape shape;
};

constexpr std::array<CavityRule, 18> kCavityRules = {{{"harmonic", Shape::ring},
                                                      {"azimuth", Shape::ring},
                                                      {"along_travel", Shape::no_ring},
                                                      {"mixing_index_travel", Shape::no_ring},
                                                      {"mixing_index", Shape::any},
                                                      {"mass_share", Shape::any},
                                                      {"expected_", Shape::any},
                                                      {"estimated_mass", Shape::any},
                                                      {"filled", Shape::any},
                                                      {"fill_ratio", Shape::any},
                                                      {"fill_height", Shape::any},
                                                      {"fill_density", Shape::any},
                                                      {"full_die_mass", Shape::any},
                                                      {"axial_variation", Shape::any},
                                                      {"top_minus_bottom", Shape::any},
                                                      {"cavity_solid_fraction", Shape::any},
                                                      {"cavity_volume", Shape::any},
                                                      {"cavity_narrowest_width", Shape::any}}};

const CavityRule* rule_of(const std::string& figure) {
  const auto* const rule =
      std::find_if(kCavityRules.begin(), kCavityRules.end(),
                   [&](const CavityRule& each) { return figure.find(each.part) != std::string::npos; });
  return rule == kCavityRules.end() ? nullptr : rule;
}

}  // namespace

std::optional<std::string> why_powder_has_no(const Scene& scene, const std::string& figure) {
  for (const PowderRule& rule : kPowderRules)
    if (figure.find(rule.part) != std::string::npos) {
      if (rule.met(scene)) return std::nullopt;
      return std::string("no run has a value of it: ") + rule.otherwise + "; choose another figure";
    }
  return std::nullopt;
}

bool depends_on_cavity(const Scene& scene, const std::string& figure) {
  const CavityRule* rule = rule_of(figure);
  if (rule == nullptr) return false;
  return rule->shape != Shape::any || !has_a_die(scene);
}

std::optional<std::string> why_cavity_has_no(const Scene& scene, const std::string& figure,
                                             std::size_t cavity, const std::vector<bool>& rings) {
  const CavityRule* rule = rule_of(figure);
  if (rule == nullptr || (rings.empty() && has_a_die(scene))) return std::nullopt;
  if (rings.empty()) return "no run has a value of it: the tools have no cavity; choose another figure";
  if (rule->shape == Shape::any || cavity > rings.size()) return std::nullopt;
  const bool ring = rings[cavity - 1];
  if (ring == (rule->shape == Shape::ring)) return std::nullopt;
  return std::string("no run has a value of it: only ") + (ring ? "cavities that are no ring" : "rings") +
         " have it, and the cavity is " + (ring ? "a ring" : "none") + "; choose another figure";
}

}  // namespace diefill::process::calibration
