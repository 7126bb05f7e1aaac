#include "process/results/probe_table.h"

#include <array>
#include <charconv>

#include "process/results/storage/atomic_file.h"
#include "process/results/storage/group_names.h"

namespace diefill::results {

namespace {

std::string shortest(double value) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  return {text.data(), end};
}

}  // namespace

std::string probe_table(const ProbeSeries& probe) {
  std::string text;
  for (std::size_t k = 0; k < probe.columns.size(); ++k)
    text += (k == 0 ? "" : ",") + probe.columns[k] + ' ' + probe.units[k];
  text += '\n';
  for (std::size_t k = 0; k < probe.values.size(); ++k) {
    const bool last = (k + 1) % probe.columns.size() == 0;
    text += shortest(probe.values[k]);
    text += last ? '\n' : ',';
  }
  return text;
}

void write_probe_tables(const std::filesystem::path& directory, const FillResult& result) {
  std::vector<std::string> names;
  for (const auto& probe : result.probes) names.push_back(probe.name);
  const auto files = group_names(names);
  for (std::size_t k = 0; k < files.size(); ++k)
    write_text_atomically(directory / ("probe_" + files[k] + ".csv"), probe_table(result.probes[k]));
}

}  // namespace diefill::results
