// The rules of coarse graining by name, as a scene gives them: those that scale forces during the simulation,
// and those that scale the parameters of the laws before.
#pragma once

#include <array>
#include <stdexcept>
#include <string>
#include <string_view>

#include "engine/coarse_graining/chu.h"
#include "engine/coarse_graining/hu_methods.h"
#include "engine/coarse_graining/sakai_koshizuka.h"
#include "engine/coarse_graining/scaled_up_particle.h"
#include "engine/coarse_graining/similar_parameters.h"
#include "engine/coarse_graining/unscaled.h"

namespace diefill::engine::coarse_graining {

struct Method {
  std::string_view name;
  ForceScaling (*scaling)(double scale);
};

/// All rules that scale forces. A new rule is registered by its line here.
inline constexpr std::array kMethods = {
    Method{"none", [](double) { return unscaled(); }},
    Method{"scaled-up particle", [](double scale) { return scaled_up_particle(scale); }},
    Method{"Hu chapter 4 method 1", [](double scale) { return scaled_up_particle(scale); }},
    Method{"Hu chapter 4 method 2", hu_chapter_4_method_2},
    Method{"Hu chapter 4 method 3", hu_chapter_4_method_3},
    Method{"Hu chapter 5 method 1", [](double scale) { return scaled_up_particle(scale); }},
    Method{"Hu chapter 5 method 2", hu_chapter_5_method_2},
    Method{"Hu chapter 5 method 3", hu_chapter_5_method_3},
    Method{"Sakai-Koshizuka", sakai_koshizuka},
    Method{"Chu", chu},
};

/// A rule that scales parameters. Torques stay force times radius.
struct ParameterRule {
  std::string_view name;
  /// Parameters of the law between grains `scale` times as large.
  laws::LawParameters (*scaled)(const laws::LawParameters& fine, double scale);
};

/// All rules that scale parameters, the usual one first. A new rule is registered by its line here.
inline constexpr std::array kParameterRules = {
    ParameterRule{"bierwisch", similar_parameters},
    ParameterRule{"Thakur", similar_parameters},  // the same numbers under the name of the other source
};

/// Null if no rule of that name scales parameters.
inline const ParameterRule* parameter_rule(std::string_view name) {
  for (const auto& rule : kParameterRules)
    if (rule.name == name) return &rule;
  return nullptr;
}

/// The rule of that name at `scale` l = d_S / d_O. Throws std::invalid_argument with the names there are.
inline ForceScaling force_scaling(std::string_view name, double scale) {
  std::string known;
  for (const auto& method : kMethods) {
    if (method.name == name) {
      if (!(scale > 0 && std::isfinite(scale)))
        throw std::invalid_argument("coarse-graining scale is " + std::to_string(scale) +
                                    "; it must be positive");
      return method.scaling(scale);
    }
    known += (known.empty() ? "'" : ", '") + std::string(method.name) + "'";
  }
  throw std::invalid_argument("no coarse-graining method '" + std::string(name) + "'; there are " + known);
}

}  // namespace diefill::engine::coarse_graining
