#include "process/input/sample_tools.h"

#include <system_error>

namespace diefill::process {

namespace fs = std::filesystem;

bool in_source_tree(const fs::path& sample_tools) {
  std::error_code unknown;
  return fs::exists(sample_tools / "../CMakeLists.txt", unknown);
}

fs::path sample_tools_beside(const fs::path& program) {
  std::error_code unknown;
  const fs::path installed = program / "../share/diefill/sample_tools",
                 built = program / "../../sample_tools";
  if (fs::exists(installed, unknown)) return fs::weakly_canonical(installed);
  if (fs::exists(built, unknown) && in_source_tree(built)) return fs::weakly_canonical(built);
  return "sample_tools";
}

fs::path sample_tools_folder() {
  std::error_code unknown;  // where /proc is not mounted
  return sample_tools_beside(fs::read_symlink("/proc/self/exe", unknown).parent_path());
}

}  // namespace diefill::process
