#include "app/pictures/source_names.h"

#include <algorithm>
#include <iterator>
#include <set>

namespace diefill::app {
namespace {

namespace fs = std::filesystem;

/// Folders of a path, the last one first.
std::vector<std::string> folders_backwards(const fs::path& directory) {
  std::vector<std::string> folders;
  for (const auto& part : fs::weakly_canonical(directory).relative_path()) folders.push_back(part.string());
  std::reverse(folders.begin(), folders.end());
  return folders;
}

/// Folders [from, to) counted from the end, joined in the order of the path.
std::string joined(const std::vector<std::string>& backwards, std::size_t from, std::size_t to) {
  std::string name;
  for (std::size_t k = std::min(to, backwards.size()); k > from; --k)
    name += (name.empty() ? "" : "_") + backwards[k - 1];
  return name;
}

std::vector<std::string> joined(const std::vector<std::vector<std::string>>& all, std::size_t from,
                                std::size_t to) {
  std::vector<std::string> names;
  for (const auto& folders : all) names.push_back(joined(folders, from, to));
  return names;
}

bool are_distinct(const std::vector<std::string>& names) {
  return std::set<std::string>(names.begin(), names.end()).size() == names.size();
}

/// Repeated names get a number.
void number_repeated(std::vector<std::string>& names) {
  std::set<std::string> taken;
  for (std::string& name : names) {
    const std::string first = name;
    for (int number = 2; !taken.insert(name).second; ++number) name = first + '_' + std::to_string(number);
  }
}

}  // namespace

std::vector<std::string> source_names(const std::vector<fs::path>& directories) {
  std::vector<std::vector<std::string>> all;
  std::size_t longest = 0;
  for (const auto& directory : directories) {
    all.push_back(folders_backwards(directory));
    longest = std::max(longest, all.back().size());
  }
  std::size_t count = 1;
  while (count < longest && !are_distinct(joined(all, 0, count))) ++count;
  if (!are_distinct(joined(all, 0, count))) count = 1;
  std::size_t common = 0;
  while (common + 1 < count && are_distinct(joined(all, common + 1, count))) ++common;
  auto names = joined(all, common, count);
  number_repeated(names);
  return names;
}

}  // namespace diefill::app
