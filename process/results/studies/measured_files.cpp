#include "process/results/studies/measured_files.h"

#include <fstream>

namespace diefill::results {
namespace {

namespace fs = std::filesystem;

/// Whether the table has the heading that write_measured_comparison() gives it.
bool has_own_heading(const fs::path& file) {
  std::ifstream stream(file);
  std::string heading;
  std::getline(stream, heading);
  return heading.find("\"measured ") != std::string::npos &&
         heading.find("\"simulated ") != std::string::npos;
}

}  // namespace

std::optional<fs::path> foreign_measured_file(const fs::path& directory, const std::string& name) {
  const std::string start = "measured_" + name;
  if (has_own_heading(directory / (start + ".csv"))) return std::nullopt;
  for (const char* end : {".csv", "_zones.csv", ".png", "_difference.png"}) {
    std::error_code none;
    if (fs::exists(directory / (start + end), none)) return directory / (start + end);
  }
  return std::nullopt;
}

}  // namespace diefill::results
