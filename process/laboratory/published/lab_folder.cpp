#include "process/laboratory/published/lab_folder.h"

#include "process/input/sample_tools.h"

namespace diefill::process::laboratory {

std::filesystem::path laboratory_folder() {
  return sample_tools_folder() / "laboratory";
}

}  // namespace diefill::process::laboratory
