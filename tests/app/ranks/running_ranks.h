// Processes of a run on ranks, found by what they were started with.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace diefill::app {

/// Those of the program `name` (mpirun, diefill-mpi) that were started with the word `argument`, which only
/// one run has.
inline std::vector<pid_t> processes_of(const std::string& name, const std::string& argument) {
  std::vector<pid_t> found;
  std::error_code gone;  // processes end while they are looked at
  for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
    const std::string number = entry.path().filename();
    if (number.find_first_not_of("0123456789") != std::string::npos) continue;
    std::ifstream file(entry.path() / "cmdline", std::ios::binary);
    const std::string words((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
    const std::filesystem::path program = words.substr(0, words.find('\0'));
    if (program.filename() == name && words.find('\0' + argument + '\0') != std::string::npos)
      found.push_back(static_cast<pid_t>(std::stol(number)));
  }
  return found;
}

}  // namespace diefill::app
