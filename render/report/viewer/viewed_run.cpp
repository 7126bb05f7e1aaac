#include "render/report/viewer/viewed_run.h"

namespace diefill::render::report {

std::vector<std::size_t> spread_instants(std::size_t instants, std::size_t most) {
  std::vector<std::size_t> places;
  const std::size_t count = instants < most ? instants : most;
  for (std::size_t n = 0; n < count; ++n) places.push_back(n * instants / count);
  return places;
}

}  // namespace diefill::render::report
