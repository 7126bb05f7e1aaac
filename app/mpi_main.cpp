// diefill-mpi: diefill whose runs are computed by LAMMPS on the ranks that mpirun or a scheduler starts. Rank
// 0 is the program, the others compute.
#include <csignal>
#include <cstdio>
#include <exception>

#include "app/commands/step_engine.h"
#include "app/exit_code.h"
#include "app/program.h"
#include "process/cluster/lammps/lammps_engine.h"

namespace {

using namespace diefill;

int run_rank(int argc, char** argv) {
  process::cluster::RankEngine ranks(MPI_COMM_WORLD);
  if (ranks.rank() != 0) {
    // Rank 0 heeds them for all: it ends the run with a checkpoint, which needs the others.
    for (const int signal : {SIGINT, SIGTERM}) std::signal(signal, SIG_IGN);
    process::cluster::serve(ranks);
    return app::kDone;
  }
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
