#include "process/cluster/mpi_command.h"

#include <netdb.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string_view>

#include "process/cluster/mpirun_output.h"
#include "process/input/shell_word.h"

namespace diefill::process::cluster {

namespace {

bool is_known(const std::string& host) {
  addrinfo* found = nullptr;
  if (getaddrinfo(host.c_str(), nullptr, nullptr, &found) != 0) return false;
  freeaddrinfo(found);
  return true;
}

/// Of the words after a host's name in its line; nothing where they do not say.
std::optional<int> slots_of(std::istringstream& words) {
  constexpr std::string_view kKey = "slots=";
  for (std::string word; words >> word;)
    if (word.starts_with(kKey)) return std::atoi(word.c_str() + kKey.size());
  return std::nullopt;
}

}  // namespace

std::vector<std::string> mpirun_words(const RankCommand& command) {
  std::vector<std::string> words = {"mpirun", "-np", std::to_string(command.ranks), "-x",
                                    std::string(kAnnounceRanks) + "=1"};
  if (command.as_root) words.emplace_back("--allow-run-as-root");
  if (!command.hostfile.empty()) {
    words.insert(words.end(), {"--hostfile", command.hostfile.string()});
  } else {
    // mpirun counts cores, not threads of them, and would bind ranks of every run to the same first cores.
    // Ranks that wait give way to what else runs here.
    words.insert(words.end(), {"--oversubscribe", "--bind-to", "none", "--mca", "mpi_yield_when_idle", "1"});
  }
  words.push_back(command.program.string());
  words.insert(words.end(), command.words.begin(), command.words.end());
  return words;
}

void check_hosts(const std::filesystem::path& hostfile, int ranks) {
  std::ifstream file(hostfile);
  if (!file) throw std::invalid_argument(hostfile.string() + ": the hostfile cannot be read");
  std::string line;
  bool any = false, counted = true;
  int slots = 0;
  for (int number = 1; std::getline(file, line); ++number) {
    std::istringstream words(line.substr(0, line.find('#')));
    std::string host;
    if (!(words >> host)) continue;
    any = true;
    if (!is_known(host))
      throw std::invalid_argument(hostfile.string() + ":" + std::to_string(number) + ": host \"" + host +
                                  "\" is unknown on this machine; correct the name or remove the line");
    const auto own = slots_of(words);
    counted = counted && own;
    slots += own.value_or(0);
  }
  if (any && counted && slots < ranks)
    throw std::invalid_argument(hostfile.string() + ": " + std::to_string(slots) + " slots for " +
                                std::to_string(ranks) + " ranks; raise slots= or lower --ranks");
  if (!any) throw std::invalid_argument(hostfile.string() + ": the hostfile names no host");
}

std::string slurm_script(const RankCommand& command) {
  std::string script =
      "#!/bin/sh\n"
      "# One filling on " +
      std::to_string(command.ranks) +
      " ranks. Submit with sbatch. If it reaches the time limit, submit it again: the run continues.\n"
      "#SBATCH --job-name=diefill\n"
      "#SBATCH --ntasks=" +
      std::to_string(command.ranks) +
      "\n"
      "#SBATCH --time=24:00:00\n"
      "#SBATCH --signal=INT@120\n"
      "exec srun --mpi=pmix " +
      shell_word(command.program.string());
  for (const std::string& word : command.words) script += ' ' + shell_word(word);
  const bool resumes =
      std::find(command.words.begin(), command.words.end(), "--resume") != command.words.end();
  return script + (resumes ? "\n" : " --resume\n");
}

}  // namespace diefill::process::cluster
