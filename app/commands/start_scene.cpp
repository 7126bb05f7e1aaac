#include "app/commands/start_scene.h"

#include <unistd.h>

#include <array>
#include <functional>
#include <system_error>

#include "app/output.h"
#include "process/input/sample_tools.h"
#include "process/input/scene_error.h"
#include "process/input/text_file.h"
#include "process/results/storage/atomic_file.h"
#include "process/scene/variants.h"

namespace diefill::app {

namespace {

namespace fs = std::filesystem;

const process::TextFileKind kSample = {"sample scene", "it comes with the program", 1 << 20};

/// A kind and the names of its sample: <stem>.toml, with tools <stem>_die.stl and so on.
struct StartScene {
  const char *kind, *stem;
};
constexpr std::array kStartScenes = {StartScene{"rectangular_die", "slot"}, StartScene{"ring", "ring_6mm"},
                                     StartScene{"gear", "gear"}};

std::string stem_of(const std::string& kind) {
  for (const auto& scene : kStartScenes)
    if (kind == scene.kind) return scene.stem;
  throw process::SceneError("--kind: there is no \"" + kind + "\"");
}

/// `text` with "<stem>_die.stl" and the like as "die.stl".
std::string without_stem(std::string text, const std::string& stem) {
  const std::string prefix = '"' + stem + '_';
  for (std::size_t at = text.find(prefix); at != std::string::npos; at = text.find(prefix, at + 1))
    text.erase(at + 1, prefix.size() - 1);
  return text;
}

void copy_sample(const fs::path& folder, const std::string& stem) {
  const fs::path samples = process::sample_tools_folder() / "small_dies";
  const std::string prefix = stem + '_';
  std::error_code unknown;
  if (!fs::exists(samples, unknown))
    throw std::runtime_error(
        "found no " + samples.string() +
        "; the samples lie beside an installed program or in its source tree: start that one, or go to the "
        "folder that holds sample_tools");
  const auto text = process::load_text_file(samples / (stem + ".toml"), kSample);
  results::write_text_atomically(folder / "fill.toml", without_stem(text, stem));
  for (const auto& entry : fs::directory_iterator(samples)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with(prefix) && name.ends_with(".stl"))
      fs::copy_file(entry.path(), folder / name.substr(prefix.size()));
  }
}

/// `given` without a slash or dot at its end, such as my_die of my_die/.
fs::path folder_named(const fs::path& given) {
  const fs::path folder = given.lexically_normal();
  return folder.has_filename() ? folder : folder.parent_path();
}

/// Makes the folder with what fill(folder) writes, all or nothing; returns its scene.
fs::path write_folder(const fs::path& given, const std::function<void(const fs::path&)>& fill) {
  const fs::path folder = folder_named(given);
  const std::string name = folder.string();
  std::error_code missing;
  if (fs::exists(fs::symlink_status(folder, missing)))
    throw process::SceneError(name + ": a file or folder of this name already exists; choose another name");
  require_directory(folder, "NAME");
  const fs::path temporary = name + '.' + std::to_string(getpid()) + ".tmp";
  const auto clean_up = [&temporary] {
    std::error_code ignored;
    fs::remove_all(temporary, ignored);
  };
  try {
    fs::create_directories(temporary);
    fill(temporary);
    fs::rename(temporary, folder);
  } catch (const fs::filesystem_error& error) {  // its text names the temporary folder
    clean_up();
    throw std::runtime_error(name + ": cannot be written: " + error.code().message() +
                             "; choose another place");
  } catch (const std::exception& error) {
    clean_up();
    throw std::runtime_error(name + ": cannot be written: " + error.what());
  }
  return folder / "fill.toml";
}

}  // namespace

std::vector<std::string> start_kinds() {
  std::vector<std::string> kinds;
  for (const auto& scene : kStartScenes) kinds.emplace_back(scene.kind);
  return kinds;
}

fs::path write_start_scene(const fs::path& folder, const std::string& kind) {
  const std::string stem = stem_of(kind);
  return write_folder(folder, [&](const fs::path& temporary) { copy_sample(temporary, stem); });
}

fs::path write_copied_scene(const fs::path& folder, const process::Scene& scene) {
  const auto where_it_lies = [](const fs::path& file) {
    return fs::absolute(file).lexically_normal().string();
  };
  return write_folder(folder, [&](const fs::path& temporary) {
    results::write_text_atomically(temporary / "fill.toml",
                                   process::scene_text_with(scene, scene.seed, where_it_lies));
  });
}

}  // namespace diefill::app
