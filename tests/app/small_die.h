// A scene that the program fills in about two seconds, in a folder of its own: a block with a pocket, a shoe
// beside it.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/app/cad.h"
#include "tests/app/program.h"
#include "tests/support/temporary_folder.h"

namespace diefill::app {

using support::contents;

/// The folder with die.stl, shoe.stl and scene.toml; gone at the end.
class SmallDie {
 public:
  SmallDie();

  const std::filesystem::path& folder() const { return folder_.path(); }
  std::filesystem::path scene() const { return folder() / "scene.toml"; }
  /// Where run() puts its results.
  std::filesystem::path out() const { return folder() / "out"; }
  void write(const std::string& name, const std::string& bytes) const { folder_.write(name, bytes); }
  /// Exchanges `old` for `text` in the scene file; throws std::logic_error if it does not stand there.
  void exchange(const std::string& old, const std::string& text) const;

  /// A tool more, drawn in mm, in front of the pour; `position` as the scene has it.
  void add_tool(const std::string& name, const std::string& role, const cad::Part& part,
                const std::string& position) const;
  /// Other steps in place of the passage.
  void exchange_passage(const std::string& steps) const;
  /// Powder at rest in the pocket, to be worked on.
  void pour_into_the_pocket() const;

  std::vector<std::string> run_arguments(const std::vector<std::string>& more = {}) const;
  Outcome run(const std::vector<std::string>& more = {}) const { return run_program(run_arguments(more)); }
  Outcome check() const { return run_program({"check", scene().string()}); }
  nlohmann::json report() const { return nlohmann::json::parse(contents(out() / "report.json")); }
  /// Names of the files in a folder, sorted.
  static std::vector<std::string> files_in(const std::filesystem::path& folder);

 private:
  support::TemporaryFolder folder_;
};

/// The parts as SmallDie writes them, mm: the pocket is 4 x 4 mm wide and 4 mm deep.
cad::Part small_die();
cad::Part small_shoe();

}  // namespace diefill::app
