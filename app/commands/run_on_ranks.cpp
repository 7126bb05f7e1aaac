#include "app/commands/run_on_ranks.h"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <thread>

#include "app/exit_code.h"
#include "process/cluster/mpi_command.h"
#include "process/cluster/rank_limits.h"
#include "process/input/scene_error.h"

namespace diefill::app {

namespace {

/// diefill-mpi, which is installed beside this program.
std::filesystem::path rank_program() {
  const auto beside = std::filesystem::read_symlink("/proc/self/exe").parent_path() / "diefill-mpi";
  if (!std::filesystem::exists(beside))
    throw std::runtime_error("runs on ranks need " + beside.string() +
                             ", which is built with cmake -DDIEFILL_MPI=ON (process/cluster/README.md)");
  return beside;
}

process::cluster::RankCommand command_of(const RankArguments& arguments,
                                         const std::vector<std::string>& words) {
  process::cluster::RankCommand command;
  command.program = rank_program();
  command.ranks = arguments.ranks;
  command.hostfile = arguments.hostfile;
  command.words = words;
  command.as_root = geteuid() == 0;
  command.cores = static_cast<int>(std::thread::hardware_concurrency());
  return command;
}

int write_script(const std::string& file, const std::string& script) {
  std::ofstream out(file);
  out << script;
  out.close();
  if (!out) throw std::runtime_error(file + ": cannot be written");
  std::printf("%s: submit it with sbatch\n", file.c_str());
  return kDone;
}

}  // namespace

void add_ranks(CLI::App& command, RankArguments& arguments) {
  auto* ranks =
      command
          .add_option("--ranks", arguments.ranks,
                      "compute on so many ranks with LAMMPS and MPI, on this machine or those of --hostfile")
          ->check(CLI::Range(1, 1000000));
  command.add_option("--hostfile", arguments.hostfile, "with --ranks: Open MPI's file of hosts")
      ->needs(ranks);
  command
      .add_option("--slurm", arguments.slurm,
                  "with --ranks: write a batch script for Slurm to this file in place of running")
      ->needs(ranks);
}

int run_on_ranks(const RankArguments& arguments, const process::Scene& scene,
                 const std::vector<std::string>& words) {
  process::cluster::refuse_what_ranks_cannot(scene);
  const auto command = command_of(arguments, words);
  if (!arguments.slurm.empty()) return write_script(arguments.slurm, process::cluster::slurm_script(command));
  if (!arguments.hostfile.empty()) {
    try {
      process::cluster::check_hosts(arguments.hostfile);
    } catch (const std::invalid_argument& error) {
      throw process::SceneError(error.what());
    }
  }
  std::vector<std::string> whole = process::cluster::mpirun_words(command);
  std::vector<char*> pointers;
  for (std::string& word : whole) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  std::fflush(nullptr);
  execvp(pointers[0], pointers.data());
  throw std::runtime_error(std::string("mpirun could not be started (") + std::strerror(errno) +
                           "): install openmpi-bin");
}

}  // namespace diefill::app
