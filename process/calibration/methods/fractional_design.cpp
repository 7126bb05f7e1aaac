#include "process/calibration/methods/fractional_design.h"

#include <algorithm>
#include <bit>
#include <map>
#include <set>
#include <stdexcept>
#include <unordered_set>

namespace diefill::process::calibration {
namespace {

using Column = std::uint64_t;

constexpr std::size_t kMaxBase = 16, kMaxGenerators = 20;
constexpr std::size_t kMaxColumnsTried = 200000;  // then a design with more runs is searched

std::string letters_of(Column column, std::size_t base) {
  std::string word;
  for (std::size_t k = 0; k < base; ++k)
    if ((column >> k & 1U) != 0) word += factor_letter(k);
  return word;
}

/// Whether `column` may join: no word shorter than `resolution` comes about.
bool fits(const std::vector<Column>& columns, Column column, std::size_t resolution) {
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (columns[i] == column) return false;
    if (resolution < 4) continue;
    for (std::size_t j = 0; j < i; ++j) {
      const Column pair = columns[i] ^ columns[j];
      if (pair == column) return false;
      if (resolution < 5) continue;
      for (std::size_t k = 0; k < j; ++k)
        if ((pair ^ columns[k]) == column) return false;
    }
  }
  return true;
}

/// Possible generators: words of at least two letters, short ones first.
std::vector<Column> candidates(std::size_t base, std::size_t resolution) {
  std::vector<Column> all;
  for (Column column = 1; column < Column{1} << base; ++column)
    if (static_cast<std::size_t>(std::popcount(column)) + 1 >= resolution) all.push_back(column);
  std::stable_sort(all.begin(), all.end(),
                   [](Column a, Column b) { return std::popcount(a) < std::popcount(b); });
  return all;
}

/// Adds columns until there are `factors`, trying others where it gets stuck.
bool extend(std::vector<Column>& columns, std::size_t factors, std::size_t resolution,
            const std::vector<Column>& all, std::size_t from, std::size_t& tried) {
  if (columns.size() == factors) return true;
  for (std::size_t k = from; k < all.size() && all.size() - k >= factors - columns.size(); ++k) {
    if (++tried > kMaxColumnsTried) return false;
    if (!fits(columns, all[k], resolution)) continue;
    columns.push_back(all[k]);
    if (extend(columns, factors, resolution, all, k + 1, tried)) return true;
    columns.pop_back();
  }
  return false;
}

std::vector<Column> base_columns(std::size_t base) {
  std::vector<Column> columns;
  for (std::size_t k = 0; k < base; ++k) columns.push_back(Column{1} << k);
  return columns;
}

/// Every word as a set of factors, bit k for factor k.
std::vector<Column> word_masks(const FractionalDesign& design) {
  const std::size_t generators = design.factors() - design.base;
  if (generators > kMaxGenerators)
    throw std::invalid_argument("a defining relation of more than 2^20 words is not written out");
  std::vector<Column> words;
  for (Column chosen = 1; chosen < Column{1} << generators; ++chosen) {
    Column word = chosen << design.base;
    for (std::size_t g = 0; g < generators; ++g)
      if ((chosen >> g & 1U) != 0) word ^= design.columns[design.base + g];
    words.push_back(word);
  }
  return words;
}

/// The same for designs with too many words: by the shortest set of columns whose product is the identity.
std::size_t shortest_of_many(const std::vector<Column>& columns) {
  const std::unordered_set<Column> single(columns.begin(), columns.end());
  if (single.size() < columns.size()) return 2;
  std::unordered_set<Column> pairs;
  bool four = false;
  for (std::size_t i = 0; i < columns.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      if (single.contains(columns[i] ^ columns[j])) return 3;
      four = !pairs.insert(columns[i] ^ columns[j]).second || four;
    }
  return four ? 4 : 5;
}

}  // namespace

std::string factor_letter(std::size_t factor) {
  static const std::string letters = "ABCDEFGHJKLMNOPQRSTUVWXYZabcdefghjklmnopqrstuvwxyz";
  const std::size_t round = factor / letters.size();
  return letters[factor % letters.size()] + (round == 0 ? "" : std::to_string(round + 1));
}

FractionalDesign design_of(std::size_t base, const std::vector<std::string>& generators) {
  if (base == 0 || base > kMaxBase) throw std::invalid_argument("a design has 1 to 16 base factors");
  FractionalDesign design{base, base_columns(base)};
  for (const std::string& word : generators) {
    Column column = 0;
    for (const char letter : word) {
      std::size_t k = 0;
      while (k < base && factor_letter(k) != std::string(1, letter)) ++k;
      if (k == base || (column >> k & 1U) != 0)
        throw std::invalid_argument("generator " + word + ": \"" + letter + "\" is no base factor, or twice");
      column |= Column{1} << k;
    }
    if (column == 0 ||
        std::find(design.columns.begin(), design.columns.end(), column) != design.columns.end())
      throw std::invalid_argument("generator " + word + ": another factor has these levels");
    design.columns.push_back(column);
  }
  return design;
}

FractionalDesign compact_design(std::size_t factors, std::size_t resolution) {
  if (factors == 0 || resolution < 3 || resolution > 5)
    throw std::invalid_argument("a design has one factor or more and resolution 3, 4 or 5");
  for (std::size_t base = 1; base <= kMaxBase; ++base) {
    if (base >= factors) return {factors, base_columns(factors)};
    FractionalDesign design{base, base_columns(base)};
    std::size_t tried = 0;
    if (extend(design.columns, factors, resolution, candidates(base, resolution), 0, tried)) return design;
  }
  throw std::invalid_argument("a design of so many factors has more than 2^16 runs");
}

int level_of_column(const FractionalDesign& design, std::size_t run, std::uint64_t column) {
  int minus = 0;
  for (std::size_t k = 0; k < design.base; ++k)
    if ((column >> k & 1U) != 0) minus += static_cast<int>(run >> (design.base - 1 - k) & 1U);
  return minus % 2 == 0 ? 1 : -1;
}

int level(const FractionalDesign& design, std::size_t run, std::size_t factor) {
  return level_of_column(design, run, design.columns[factor]);
}

std::size_t resolution_of(const FractionalDesign& design) {
  if (design.factors() == design.base) return 0;
  if (design.factors() - design.base > kMaxGenerators) return shortest_of_many(design.columns);
  std::size_t shortest = design.factors();
  for (const Column word : word_masks(design))
    shortest = std::min(shortest, static_cast<std::size_t>(std::popcount(word)));
  return shortest;
}

std::vector<std::string> generators_of(const FractionalDesign& design) {
  std::vector<std::string> texts;
  for (std::size_t k = design.base; k < design.factors(); ++k)
    texts.push_back(factor_letter(k) + " = " + letters_of(design.columns[k], design.base));
  return texts;
}

std::vector<std::string> defining_words(const FractionalDesign& design) {
  std::vector<std::string> words;
  for (const Column word : word_masks(design)) words.push_back(letters_of(word, design.factors()));
  std::sort(words.begin(), words.end(), [](const std::string& a, const std::string& b) {
    return a.size() != b.size() ? a.size() < b.size() : a < b;
  });
  return words;
}

std::vector<AliasString> alias_strings(const FractionalDesign& design) {
  std::vector<AliasString> strings;
  std::map<Column, std::size_t> place;
  const auto string_of = [&](Column column) -> AliasString& {
    const auto [found, is_new] = place.try_emplace(column, strings.size());
    if (is_new) strings.push_back({column, {}, {}});
    return strings[found->second];
  };
  for (std::size_t k = 0; k < design.factors(); ++k) string_of(design.columns[k]).factors.push_back(k);
  for (std::size_t i = 0; i < design.factors(); ++i)
    for (std::size_t j = i + 1; j < design.factors(); ++j)
      string_of(design.columns[i] ^ design.columns[j]).pairs.emplace_back(i, j);
  return strings;
}

std::string text_of(const AliasString& string) {
  std::string text;
  for (const std::size_t factor : string.factors) text += (text.empty() ? "" : " = ") + factor_letter(factor);
  for (const auto& [i, j] : string.pairs)
    text += (text.empty() ? "" : " = ") + factor_letter(i) + factor_letter(j);
  return text;
}

}  // namespace diefill::process::calibration
