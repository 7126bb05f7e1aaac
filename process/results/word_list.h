// Lists of names in sentences.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

namespace diefill::results {

/// The first `most` names, separated by commas, then " and N more"; `last` stands before the last name where
/// all are listed.
inline std::string comma_list(const std::vector<std::string>& names, std::size_t most,
                              const std::string& last = ", ") {
  std::string list;
  for (std::size_t k = 0; k < std::min(most, names.size()); ++k)
    list += (k == 0 ? "" : k + 1 == names.size() ? last : ", ") + names[k];
  if (names.size() > most) list += " and " + std::to_string(names.size() - most) + " more";
  return list;
}

/// All of them, such as "die, core rod and lower punch".
inline std::string and_list(const std::vector<std::string>& names) {
  return comma_list(names, names.size(), " and ");
}

}  // namespace diefill::results
