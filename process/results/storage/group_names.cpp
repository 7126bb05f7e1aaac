#include "process/results/storage/group_names.h"

#include <algorithm>
#include <set>

namespace diefill::results {
namespace {

bool plain(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_';
}

}  // namespace

std::vector<std::string> group_names(const std::vector<std::string>& names) {
  std::vector<std::string> unique;
  std::set<std::string> taken;
  for (std::string name : names) {
    std::replace_if(
        name.begin(), name.end(), [](char c) { return !plain(c); }, '_');
    if (name.empty()) name = "unnamed";
    std::string candidate = name;
    for (int number = 2; !taken.insert(candidate).second; ++number)
      candidate = name + "_" + std::to_string(number);
    unique.push_back(candidate);
  }
  return unique;
}

}  // namespace diefill::results
