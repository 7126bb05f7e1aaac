// What a step, a snapshot or a stop waits for: a time, another step, the powder at rest, or a measured
// quantity.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "process/input/table_reader.h"

namespace diefill::process {

/// When powder counts as at rest by its kinetic energy alone.
struct RestLimits {
  double energy = 1e-4;  ///< kinetic energy per grain over m g d
  double time = 0.01;    ///< s that it stays below
};

/// All given parts must hold. Measured quantities count from when `after`, `with`, `at` and `delay` are
/// fulfilled, so powder that rested before does not count. Once it has held, it stays fulfilled.
struct Condition {
  std::string after;         ///< name of a step that has ended; empty: none
  std::string with;          ///< name of a step that has begun; empty: none
  std::optional<double> at;  ///< s since the poured powder came to rest
  double delay = 0;          ///< s after `after`, `with` or what counts as such
  bool at_rest = false;
  std::optional<RestLimits> limits;   ///< of rest; nothing: those of process/tooling/rest.h
  std::optional<double> filled_mass;  ///< kg in the cavity, at least
  std::optional<double> force;        ///< N on the tool `on`, at least
  std::string on;
  std::string where;  ///< place in the scene file, for messages

  bool measures() const { return at_rest || filled_mass || force; }
};

/// Reads the table under `key` of a step or snapshot, such as `start = { after = "fill" }`; nothing when it
/// is absent. `tools` are the names that `on` may have. Throws SceneError.
std::optional<Condition> read_condition(TableReader& table, const std::string& key,
                                        const std::vector<std::string>& tools);

}  // namespace diefill::process
