#include "process/laboratory/published/lab_folder.h"

namespace diefill::process::laboratory {

std::filesystem::path laboratory_folder() {
  namespace fs = std::filesystem;
  const fs::path beside = fs::read_symlink("/proc/self/exe").parent_path() / "../../sample_tools/laboratory";
  return fs::exists(beside) ? fs::weakly_canonical(beside) : fs::path("sample_tools/laboratory");
}

}  // namespace diefill::process::laboratory
