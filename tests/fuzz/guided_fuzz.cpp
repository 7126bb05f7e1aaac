// Damaged CAD files for the importers, the check and the repair, guided by coverage (libFuzzer); README.md.
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "tests/fuzz/fuzz_input.h"
#include "tests/fuzz/shared_coverage.h"
#include "tests/support/temporary_folder.h"

namespace {

/// Kinds of file to leave to another run, as FUZZ_WITHOUT="step igs 3mf" in the environment.
bool is_left_out(const std::string& ending) {
  const char* const kinds = std::getenv("FUZZ_WITHOUT");
  return kinds != nullptr && std::string(kinds).find(ending) != std::string::npos;
}

}  // namespace

/// Puts the seeds into the corpus: the folder named last.
extern "C" int LLVMFuzzerInitialize(int* count, char*** arguments) {
  using namespace diefill::geometry::fuzz;
  share_coverage_with_children();
  const std::filesystem::path corpus = (*arguments)[*count - 1];
  if (*count < 2 || !std::filesystem::is_directory(corpus)) return 0;
  std::size_t number = 0;
  for (const FuzzInput& seed : seeds()) {
    const auto file = corpus / ("seed" + std::to_string(number++));
    if (!is_left_out(seed.ending) && !std::filesystem::exists(file))
      std::ofstream(file, std::ios::binary) << packed(seed);
  }
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace diefill;
  static const support::TemporaryFolder folder;
  if (size < 2) return 0;
  const auto input = geometry::fuzz::unpacked({reinterpret_cast<const char*>(data), size});
  if (is_left_out(input.ending)) return -1;
  geometry::fuzz::outcome_of(folder.write("input." + input.ending, input.bytes));
  return 0;
}
