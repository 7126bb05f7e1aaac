// Distance of a run from the limits of the method, and on which side each limit counts.
#pragma once

#include <string>
#include <vector>

#include "process/results/fill_result.h"

namespace diefill::results {

/// One limit. Margins without numbers, as of older results, are left out.
struct Margin {
  std::string name;
  double found = 0, limit = 0;
  bool either_side = false;  ///< the limit holds for found and for -found; otherwise only above counts

  double share() const;  ///< of the limit, on the side that counts; 0 where the other side is meant
  bool exceeded() const { return share() > 1; }
};

std::vector<Margin> margins(const FillResult& result);

/// A line for every limit that was exceeded: what, by how much, what to do.
std::vector<std::string> exceeded_text(const FillResult& result);

}  // namespace diefill::results
