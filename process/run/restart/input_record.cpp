#include "process/run/restart/input_record.h"

#include <algorithm>
#include <sstream>

#include "process/input/shown_value.h"
#include "process/results/storage/atomic_file.h"
#include "process/results/storage/file_contents.h"
#include "process/results/storage/result_file.h"

namespace diefill::process {
namespace {

constexpr const char* kInputTopic = "input files";  // of the results

}  // namespace

void add_input_files(const std::vector<InputFile>& files, results::FillResult& result) {
  if (files.empty()) return;
  results::Topic topic{kInputTopic, {}, {}};
  for (const InputFile& file : files) {
    topic.name.push_back(file.name);
    topic.text.push_back(file.hash);
  }
  result.topics.push_back(std::move(topic));
}

std::optional<std::vector<InputFile>> recorded_input_files(const results::FillResult& result) {
  const auto found = std::find_if(result.topics.begin(), result.topics.end(),
                                  [](const results::Topic& topic) { return topic.topic == kInputTopic; });
  if (found == result.topics.end()) return std::nullopt;
  std::vector<InputFile> files;
  for (std::size_t k = 0; k < std::min(found->name.size(), found->text.size()); ++k)
    files.push_back({found->name[k], found->text[k]});
  return files;
}

std::filesystem::path input_record_file(const std::filesystem::path& directory) {
  return directory / "checkpoint.inputs";
}

void write_input_record(const std::filesystem::path& directory, const std::vector<InputFile>& files) {
  if (files.empty()) return;
  constexpr std::size_t kLongest = 4096;  // of a path
  std::string lines;
  for (const InputFile& file : files) lines += file.hash + ' ' + one_line(file.name, kLongest) + '\n';
  results::write_text_atomically(input_record_file(directory), lines);
}

std::optional<std::vector<InputFile>> read_input_record(const std::filesystem::path& directory) {
  const auto text = results::contents_or_nothing(input_record_file(directory));
  if (!text) return std::nullopt;
  std::vector<InputFile> files;
  std::istringstream lines(*text);
  for (InputFile file; lines >> file.hash && std::getline(lines >> std::ws, file.name);)
    files.push_back(file);
  return files;
}

std::optional<std::vector<InputFile>> input_files_read_in(const std::filesystem::path& directory) {
  try {
    if (auto files = read_input_record(directory)) return files;
    if (!std::filesystem::exists(directory / "results.h5")) return std::nullopt;
    return recorded_input_files(results::read_results(directory));
  } catch (const results::ResultError&) {
    return std::nullopt;
  }
}

std::optional<std::string> changed_file(const std::vector<InputFile>& files,
                                        const std::vector<InputFile>& then) {
  for (std::size_t k = 0; k < files.size(); ++k)
    if (k >= then.size() || then[k].hash != files[k].hash) return files[k].name;
  return std::nullopt;
}

}  // namespace diefill::process
