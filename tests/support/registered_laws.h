// Every contact law that [contact] can name, put together from the registry of its parts: a part that is
// registered later is among them without a change here.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "process/scene/contact/contact_parts.h"
#include "process/scene/scene.h"
#include "tests/support/scene_text.h"

namespace diefill::support {

/// A law in the words of [contact], and a scene of rotating spheres of 5 mm that it acts between.
struct RegisteredLaw {
  std::string contact;
  process::Scene scene;
};

/// The parts of one kind as scenes may name them.
struct PartsOfKind {
  std::string kind;
  std::vector<std::string> examples;
  bool has_none = false;  ///< the first one does nothing
};

template <class Parameters>
PartsOfKind parts_of_kind(const std::string& kind, const process::ContactParts<Parameters>& parts) {
  PartsOfKind all{kind, {}, parts.front().name == "none"};
  for (const auto& part : parts) all.examples.push_back(part.example);
  return all;
}

constexpr std::size_t kKindsOfParts = 5;

inline std::array<PartsOfKind, kKindsOfParts> registered_parts() {
  return {parts_of_kind("normal", process::normal_parts()),
          parts_of_kind("damping", process::damping_parts()),
          parts_of_kind("friction", process::friction_parts()),
          parts_of_kind("rolling", process::rolling_parts()),
          parts_of_kind("attraction", process::attraction_parts())};
}

/// The scene with this [contact]; nothing where the parts do not go together. `file`: in a folder with the
/// tools' files.
inline std::optional<RegisteredLaw> law_of(const std::string& contact, const std::filesystem::path& file) {
  SceneTables tables;
  tables.powder =
      "model = \"B\"\nsphere_radius = \"2.5 mm\"\ngrain_mass = \"1.6e-4 kg\"\ngrain_diameter = \"5 mm\"\n";
  tables.steps = "[[step]]\nkind = \"wait\"\nduration = \"1 ms\"\n";
  const std::string text = exchanged(scene_text(tables), "[walls]",
                                     "[contact]\ncoarse_graining = \"none\"\n" + contact + "\n[walls]");
  try {
    return RegisteredLaw{contact, process::parse_scene(text, file)};
  } catch (const process::SceneError&) {
    return std::nullopt;
  }
}

/// The law with the parts that `chosen` names, one of a kind or none, and for the others the first that go
/// with them: any normal force, damping and friction rather than none, and nothing else. Nothing where no
/// such law makes sense.
inline std::optional<RegisteredLaw> completed(const std::array<std::string, kKindsOfParts>& chosen,
                                              const std::filesystem::path& file) {
  const auto parts = registered_parts();
  std::array<std::vector<std::string>, kKindsOfParts> candidates;
  for (std::size_t kind = 0; kind < kKindsOfParts; ++kind) {
    if (!chosen[kind].empty())
      candidates[kind] = {chosen[kind]};
    else if (kind < 3)
      candidates[kind] = parts[kind].examples;
    else
      candidates[kind] = {parts[kind].examples.front()};
    if (chosen[kind].empty() && kind < 3 && parts[kind].has_none)
      std::rotate(candidates[kind].begin(), candidates[kind].begin() + 1, candidates[kind].end());
  }
  for (const auto& normal : candidates[0])
    for (const auto& damping : candidates[1])
      for (const auto& friction : candidates[2])
        if (auto law = law_of("normal = " + normal + "\ndamping = " + damping + "\nfriction = " + friction +
                                  "\nrolling = " + candidates[3].front() +
                                  "\nattraction = " + candidates[4].front() + "\n",
                              file))
          return law;
  return std::nullopt;
}

/// Every part by itself, with what completes it.
inline std::vector<RegisteredLaw> laws_singly(const std::filesystem::path& file) {
  std::vector<RegisteredLaw> laws;
  std::set<std::string> seen;
  const auto parts = registered_parts();
  for (std::size_t kind = 0; kind < kKindsOfParts; ++kind)
    for (const auto& example : parts[kind].examples) {
      std::array<std::string, kKindsOfParts> chosen;
      chosen[kind] = example;
      if (auto law = completed(chosen, file); law && seen.insert(law->contact).second)
        laws.push_back(std::move(*law));
    }
  return laws;
}

/// Every two parts of different kinds that go together, with what completes them.
inline std::vector<RegisteredLaw> laws_in_pairs(const std::filesystem::path& file) {
  std::vector<RegisteredLaw> laws;
  std::set<std::string> seen;
  const auto parts = registered_parts();
  for (std::size_t one = 0; one < kKindsOfParts; ++one)
    for (std::size_t other = one + 1; other < kKindsOfParts; ++other)
      for (const auto& first : parts[one].examples)
        for (const auto& second : parts[other].examples) {
          std::array<std::string, kKindsOfParts> chosen;
          chosen[one] = first;
          chosen[other] = second;
          if (auto law = completed(chosen, file); law && seen.insert(law->contact).second)
            laws.push_back(std::move(*law));
        }
  return laws;
}

}  // namespace diefill::support
