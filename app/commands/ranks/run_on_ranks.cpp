#include "app/commands/ranks/run_on_ranks.h"

#include <unistd.h>

#include <cstdio>
#include <filesystem>

#include "app/commands/ranks/mpirun_child.h"
#include "app/commands/ranks/step_engine.h"
#include "app/commands/shared_options/scene_choice.h"
#include "app/exit_code.h"
#include "app/options/numbers.h"
#include "app/options/output_file.h"
#include "app/output.h"
#include "process/cluster/mpi_command.h"
#include "process/cluster/rank_limits.h"
#include "process/input/scene_error.h"
#include "process/results/storage/atomic_file.h"

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

/// The arguments of `command`, except the options of add_ranks().
std::vector<std::string> arguments_of(const CLI::App& command) {
  std::vector<std::string> words = {command.get_name()}, named;
  for (const CLI::Option* option : command.get_options()) {
    const std::string name = option->get_name();
    if (option->count() == 0 || name == "--ranks" || name == "--hostfile" || name == "--slurm") continue;
    if (option->get_positional())
      words.insert(words.end(), option->results().begin(), option->results().end());
    else if (option->get_expected_max() == 0)
      named.push_back(name);
    else
      for (const std::string& value : option->results()) named.insert(named.end(), {name, value});
  }
  words.insert(words.end(), named.begin(), named.end());
  return words;
}

process::cluster::RankCommand command_of(const RankArguments& arguments) {
  process::cluster::RankCommand command;
  command.program = rank_program();
  command.ranks = arguments.ranks;
  command.hostfile = arguments.hostfile;
  command.words = arguments_of(*arguments.command);
  command.as_root = geteuid() == 0;
  return command;
}

int write_script(const std::string& file, const std::string& script) {
  write_output([&] { results::write_text_atomically(file, script); });
  std::printf("%s: submit it with sbatch\n", file.c_str());
  return kDone;
}

}  // namespace

void add_ranks(CLI::App& command, RankArguments& arguments) {
  arguments.command = &command;
  auto* ranks =
      command
          .add_option(
              "--ranks", arguments.ranks,
              "compute on this many ranks with LAMMPS and MPI, on this machine or those of --hostfile")
          ->check(whole_number(1, 1000000));
  command.add_option("--hostfile", arguments.hostfile, "with --ranks: hostfile of Open MPI")->needs(ranks);
  command
      .add_option("--slurm", arguments.slurm,
                  "with --ranks: write a batch script for Slurm to this file instead of running")
      ->needs(ranks);
}

int run_on_ranks(const RankArguments& arguments, const process::Scene& scene) {
  if (step_engine() != nullptr)
    throw process::SceneError(
        "--ranks: mpirun -np says on how many ranks diefill-mpi runs; leave the option out");
  process::cluster::refuse_unsupported_on_ranks(scene);
  const auto command = command_of(arguments);
  if (!arguments.slurm.empty()) {
    const OutputFile file = {"--slurm", arguments.slurm, {".sh", ".slurm", ".sbatch", ".job"}};
    auto inputs = input_files_of(scene);
    inputs.emplace_back(arguments.hostfile);
    require_output_file(file, inputs);
    make_directory_of(file);
    return write_script(arguments.slurm, process::cluster::slurm_script(command));
  }
  if (!arguments.hostfile.empty()) {
    try {
      process::cluster::check_hosts(arguments.hostfile, arguments.ranks);
    } catch (const std::invalid_argument& error) {
      throw process::SceneError(error.what());
    }
  }
  return run_mpirun(process::cluster::mpirun_words(command));
}

}  // namespace diefill::app
