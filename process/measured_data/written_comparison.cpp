#include "process/measured_data/written_comparison.h"

#include <algorithm>
#include <string_view>

namespace diefill::process {
namespace {

// As process/results/studies/measured_comparison writes them.
constexpr std::string_view kMeasured = "measured ", kSimulated = "simulated ", kDifference = "difference of ";

bool any_starts_with(const std::vector<std::string>& names, std::string_view start) {
  return std::any_of(names.begin(), names.end(),
                     [start](const std::string& name) { return name.starts_with(start); });
}

}  // namespace

bool is_written_comparison(const std::vector<std::string>& names) {
  return any_starts_with(names, kMeasured) && any_starts_with(names, kSimulated) &&
         any_starts_with(names, kDifference);
}

std::vector<std::string> names_of_measurement(const std::vector<std::string>& names) {
  if (!is_written_comparison(names)) return names;
  std::vector<std::string> meant;
  for (const std::string& name : names) {
    const bool is_result = name.starts_with(kSimulated) || name.starts_with(kDifference);
    meant.push_back(is_result                     ? std::string()
                    : name.starts_with(kMeasured) ? name.substr(kMeasured.size())
                                                  : name);
  }
  return meant;
}

}  // namespace diefill::process
