#include "process/input/sample_tools.h"

#include <array>
#include <system_error>

namespace diefill::process {

std::filesystem::path sample_tools_folder() {
  namespace fs = std::filesystem;
  std::error_code unknown;  // where /proc is not mounted
  const fs::path program = fs::read_symlink("/proc/self/exe", unknown).parent_path();
  constexpr std::array kPlaces = {"../../sample_tools", "../share/diefill/sample_tools"};
  for (const char* place : kPlaces)
    if (fs::exists(program / place)) return fs::weakly_canonical(program / place);
  return "sample_tools";
}

}  // namespace diefill::process
