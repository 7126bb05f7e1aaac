// diefill run --ranks: the same run by diefill-mpi under mpirun, or a script that has a scheduler start it.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "process/scene/scene.h"

namespace diefill::app {

struct RankArguments {
  int ranks = 0;  ///< 0: this program computes
  std::string hostfile, slurm;
  const CLI::App* command = nullptr;  ///< the command with these options
};

/// Adds --ranks, --hostfile and --slurm to a command.
void add_ranks(CLI::App& command, RankArguments& arguments);

/// Runs the same command on ranks, without the options above, or writes the script. Returns the exit code.
/// Throws process::SceneError for what ranks cannot do, std::runtime_error where the programs are missing.
int run_on_ranks(const RankArguments& arguments, const process::Scene& scene);

}  // namespace diefill::app
