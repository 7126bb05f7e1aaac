#include "process/input/nearest_key.h"

#include <algorithm>
#include <cctype>
#include <numeric>

namespace diefill::process {
namespace {

constexpr std::size_t kLongest = 200;  // letters; the distance takes the product of both lengths in time

std::string plain(std::string word) {
  for (char& letter : word) {
    letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
    if (letter == '-' || letter == ' ') letter = '_';
  }
  return word;
}

/// The one word that begins with `word`; nothing where several do, and for beginnings too short to tell.
std::optional<std::string> only_continuation(const std::string& word, const std::vector<std::string>& known) {
  constexpr std::size_t kShortest = 3;  // letters
  if (word.size() < kShortest || word.size() > kLongest) return std::nullopt;
  const std::string beginning = plain(word);
  std::optional<std::string> found;
  for (const std::string& candidate : known) {
    if (candidate.size() > kLongest || !plain(candidate).starts_with(beginning)) continue;
    if (found && *found != candidate) return std::nullopt;
    found = candidate;
  }
  return found;
}

}  // namespace

std::size_t edit_distance(const std::string& a, const std::string& b) {
  const std::string from = plain(a), to = plain(b);
  // Rows of the distances between the beginnings of `from` and of `to`: the last two, and the one being
  // filled.
  std::vector<std::size_t> before_last(to.size() + 1), last(to.size() + 1), row(to.size() + 1);
  std::iota(last.begin(), last.end(), std::size_t{0});
  for (std::size_t i = 1; i <= from.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= to.size(); ++j) {
      const std::size_t replaced = last[j - 1] + (from[i - 1] == to[j - 1] ? 0 : 1);
      row[j] = std::min({replaced, last[j] + 1, row[j - 1] + 1});
      if (i > 1 && j > 1 && from[i - 1] == to[j - 2] && from[i - 2] == to[j - 1])
        row[j] = std::min(row[j], before_last[j - 2] + 1);
    }
    before_last.swap(last);
    last.swap(row);
  }
  return last.back();
}

std::optional<std::string> nearest_key(const std::string& word, const std::vector<std::string>& known) {
  if (auto continuation = only_continuation(word, known)) return continuation;
  std::optional<std::string> nearest;
  std::size_t least = 0;
  for (const std::string& candidate : known) {
    const std::size_t longer = std::max(word.size(), candidate.size());
    if (longer > kLongest) continue;
    const std::size_t distance = edit_distance(word, candidate);
    if (distance > 2 && 3 * distance > longer) continue;
    if (2 * distance >= longer) continue;
    if (!nearest || distance < least) {
      nearest = candidate;
      least = distance;
    }
  }
  return nearest;
}

}  // namespace diefill::process
