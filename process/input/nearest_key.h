// Finds the known word nearest to a mistyped or shortened one.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace diefill::process {

/// Number of insertions, deletions and replacements of a letter and of swaps of two neighbouring ones that
/// turn `a` into `b` (optimal string alignment), after making both lower case and taking '-' and ' ' for '_'.
std::size_t edit_distance(const std::string& a, const std::string& b);

/// The one known word that `word` (three letters or more) is the beginning of; else the known word nearest to
/// it, the first of equally near ones; nothing when none is near enough (more than two changes, or more than
/// a third of the longer word).
std::optional<std::string> nearest_key(const std::string& word, const std::vector<std::string>& known);

}  // namespace diefill::process
