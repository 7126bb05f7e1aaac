#include "tests/fuzz/shared_coverage.h"

#include <sys/mman.h>
#include <unistd.h>

#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <vector>

// Where clang keeps the counters of the code it instrumented.
extern "C" {
extern std::uint8_t __start___sancov_cntrs __attribute__((weak, visibility("hidden")));
extern std::uint8_t __stop___sancov_cntrs __attribute__((weak, visibility("hidden")));
}

namespace diefill::geometry::fuzz {

void share_coverage_with_children() {
  const auto page = static_cast<std::uintptr_t>(::sysconf(_SC_PAGESIZE));
  // Whole pages only: what else lies on the first and the last must stay each process's own.
  const auto first = (reinterpret_cast<std::uintptr_t>(&__start___sancov_cntrs) + page - 1) / page * page;
  const auto last = reinterpret_cast<std::uintptr_t>(&__stop___sancov_cntrs) / page * page;
  if (last <= first) return;
  auto* const place = reinterpret_cast<std::uint8_t*>(first);
  const std::vector<std::uint8_t> counters(place, place + (last - first));
  void* const shared =
      ::mmap(place, last - first, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS | MAP_FIXED, -1, 0);
  if (shared == MAP_FAILED) throw std::runtime_error("coverage cannot be shared with child processes");
  std::memcpy(shared, counters.data(), counters.size());
}

}  // namespace diefill::geometry::fuzz
