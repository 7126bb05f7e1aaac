// The command line that starts a run on ranks, and the script that has a scheduler do so.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace diefill::process::cluster {

/// Where and on how many ranks.
struct RankCommand {
  std::filesystem::path program;  ///< diefill-mpi
  int ranks = 1;
  std::filesystem::path hostfile;  ///< empty: this machine
  std::vector<std::string> words;  ///< of the program: run, the scene and its options
  bool as_root = false;            ///< Open MPI asks for a word where root starts ranks
};

/// Words of the command, mpirun first.
std::vector<std::string> mpirun_words(const RankCommand& command);

/// Throws std::invalid_argument in one line, with file and line, where the hostfile cannot be read, names no
/// host, a host whose name is not known, or fewer slots than ranks.
void check_hosts(const std::filesystem::path& hostfile, int ranks);

/// A batch script for Slurm. The scheduler chooses the hosts; the run continues from a checkpoint that is
/// there.
std::string slurm_script(const RankCommand& command);

}  // namespace diefill::process::cluster
