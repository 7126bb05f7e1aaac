// The scene of a command: as its file has it, or with the numbers of a setting.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "process/scene/scene.h"
#include "process/scene/variants.h"
#include "process/tooling/tooling.h"

namespace diefill::app {

/// Adds --setting to a command; returns it for conditions.
CLI::Option* add_setting(CLI::App& command, std::string& setting);

/// Adds --set to a command: keys of the scene that are changed, a TOML assignment each. Returns it for
/// conditions.
CLI::Option* add_changes(CLI::App& command, std::vector<std::string>& changes);

/// Adds --variant to a command: the name of one [[variant]] of the scene. Returns it for conditions.
CLI::Option* add_variant(CLI::App& command, std::string& variant);

/// Reads the scene with `changes` (of --set) applied. Throws process::SceneError.
process::Scene changed_scene(const std::string& file, const std::vector<std::string>& changes);

/// The files that the scene is made of: its own, CAD of its tools, tables and shapes that it names.
std::vector<std::filesystem::path> input_files_of(const process::Scene& scene);

/// Prints on standard error what a setting chose and replaced in the scene, if one did.
void print_setting_choices(const process::Scene& scene);

/// Reads the scene with `changes` (of --set). A setting of this name (empty: the scene's own, if it has one)
/// is turned into numbers, and what it chose is said. Throws process::SceneError.
process::Scene chosen_scene(const std::string& file, const std::string& setting,
                            const std::vector<std::string>& changes);

/// Reads the scene's variants. A setting of this name (empty: none) gives all of them the same numbers, and
/// what it chose is said, once where it is the same. Throws process::SceneError.
std::vector<process::Variant> chosen_variants(const std::string& file, const std::string& setting);

/// Names of the scene's variants; empty: it has none. Throws process::SceneError.
std::vector<std::string> names_of_variants(const std::string& file);

/// The variant of this name, as chosen_scene() gives a scene; a setting gives it the numbers that suit all
/// variants. Throws process::SceneError.
process::Scene chosen_variant(const std::string& file, const std::string& name, const std::string& setting);

/// The scene's tools, ready to be filled, with progress where requested. Throws process::SceneError or
/// geometry::MeshError.
process::Tooling prepared_tooling(const process::Scene& scene, bool show_progress);

}  // namespace diefill::app
