#include "app/exit_code.h"

#include <cstdio>
#include <exception>
#include <filesystem>
#include <new>
#include <nlohmann/json.hpp>
#include <string>
#include <system_error>

#include "engine/limits/validity_monitor.h"
#include "geometry/mesh/mesh.h"
#include "process/input/scene_error.h"
#include "process/input/shown_value.h"
#include "process/results/storage/result_file.h"
#include "process/run/fill_run.h"

namespace diefill::app {

namespace {

int complain(const char* message, ExitCode code) {
  // Texts from files and file names may hold anything; a line is what a terminal or a log can show.
  constexpr std::size_t kLongest = 3000;
  const std::string line = process::one_line(process::with_short_words(message), kLongest);
  std::fprintf(stderr, "diefill: %s\n", line.c_str());
  return code;
}

/// A name that no file can have is bad input; other faults are those of the machine.
int complain_of_file(const std::filesystem::filesystem_error& error) {
  const bool bad_name = error.code() == std::errc::filename_too_long;
  const std::string message = error.path1().string() + ": " + error.code().message() + "; check the path" +
                              (bad_name ? "" : " and its permissions");
  return complain(message.c_str(), bad_name ? kBadInput : kFailed);
}

}  // namespace

int guarded(const std::function<int()>& action) {
  try {
    return action();
  } catch (const process::SceneError& error) {
    return complain(error.what(), kBadInput);
  } catch (const geometry::MeshError& error) {
    return complain(error.what(), kBadInput);
  } catch (const results::ResultError& error) {
    return complain(error.what(), kBadInput);
  } catch (const engine::OutOfRange& error) {
    return complain(error.what(), kOutOfRange);
  } catch (const process::Interrupted& stop) {
    return complain(stop.what(), kInterrupted);
  } catch (const nlohmann::json::exception& error) {
    const std::string wrong = std::string("invalid JSON: ") + error.what() +
                              "; check the JSON files that the command reads, and that file names are valid "
                              "UTF-8";
    return complain(wrong.c_str(), kBadInput);
  } catch (const std::bad_alloc&) {
    return complain("out of memory: use larger grains or larger wall spheres", kFailed);
  } catch (const std::filesystem::filesystem_error& error) {
    return complain_of_file(error);
  } catch (const std::exception& error) {
    return complain(error.what(), kFailed);
  }
}

}  // namespace diefill::app
