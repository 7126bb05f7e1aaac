// diefill-mpi: diefill whose runs are computed by LAMMPS on the ranks that mpirun or a scheduler starts. Rank
// 0 is the program, the others compute.
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string_view>

#include "app/commands/ranks/step_engine.h"
#include "app/exit_code.h"
#include "app/program.h"
#include "process/cluster/lammps/lammps_engine.h"
#include "process/cluster/mpirun_output.h"

namespace {

using namespace diefill;

/// Why the program cannot do what it is asked for; nullptr where it can.
const char* refusal(int argc, char** argv, int ranks) {
  // Other commands start programs of their own, which must not be ranks.
  if (argc > 1 && argv[1][0] != '-' && std::string_view(argv[1]) != "run")
    return "diefill-mpi supports only the command run; use diefill for the others";
  const char* tasks = std::getenv("SLURM_STEP_NUM_TASKS");
  const bool alone = ranks == 1 && std::getenv("OMPI_COMM_WORLD_SIZE") == nullptr;
  if (alone && tasks != nullptr && std::atoi(tasks) > 1)
    return "Slurm started the tasks as separate programs of one rank each; start them with srun --mpi=pmix";
  return nullptr;
}

int run_rank(int argc, char** argv) {
  process::cluster::RankEngine ranks(MPI_COMM_WORLD);
  const char* refused = refusal(argc, argv, ranks.ranks());
  if (refused != nullptr && ranks.rank() == 0) std::fprintf(stderr, "diefill: %s\n", refused);
  if (refused != nullptr) return ranks.rank() == 0 ? app::kBadInput : app::kDone;
  if (ranks.rank() != 0) {
    // Rank 0 heeds them for all: it ends the run with a checkpoint, which needs the others.
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGUSR1}) std::signal(signal, SIG_IGN);
    process::cluster::serve(ranks);
    return app::kDone;
  }
  if (std::getenv(process::cluster::kAnnounceRanks) != nullptr)
    std::fprintf(stderr, "%s\n", process::cluster::kRanksBegin.data());
  process::cluster::LammpsEngine engine(ranks);
  app::step_engine() = &engine;
  return app::run_program(argc, argv);
}

}  // namespace

int main(int argc, char** argv) {
  int provided = 0;
  MPI_Init_thread(&argc, &argv, MPI_THREAD_FUNNELED, &provided);
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  try {
    const int code = run_rank(argc, argv);
    MPI_Finalize();
    return code;
  } catch (const process::cluster::OtherRelease& error) {
    if (rank == 0) std::fprintf(stderr, "diefill: %s\n", error.what());
    MPI_Finalize();
    return app::kFailed;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "diefill: rank %d: %s\n", rank, error.what());
    std::fflush(stderr);
    MPI_Abort(MPI_COMM_WORLD, app::kFailed);
  }
}
