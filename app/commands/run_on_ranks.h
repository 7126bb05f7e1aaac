// diefill run --ranks: the same run by diefill-mpi under mpirun, or a script that has a scheduler start it.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "process/scene/scene.h"

namespace diefill::app {

struct RankArguments {
  int ranks = 0;  ///< 0: this program computes
  std::string hostfile, slurm;
};

/// Adds --ranks, --hostfile and --slurm to a command.
void add_ranks(CLI::App& command, RankArguments& arguments);

/// Starts the run, `words` being those of the command without the options above, or writes the script. Does
/// not return where a run starts. Throws process::SceneError for what ranks cannot do, std::runtime_error
/// where the programs are missing.
int run_on_ranks(const RankArguments& arguments, const process::Scene& scene,
                 const std::vector<std::string>& words);

}  // namespace diefill::app
