// Tests on ranks: rank 0 runs them, the others compute.
#include "tests/cluster/ranks.h"

namespace diefill::process::cluster {

namespace {

LammpsEngine* shared_engine = nullptr;

int run_tests(int argc, char** argv) {
  RankEngine ranks(MPI_COMM_WORLD);
  if (ranks.rank() != 0) {
    serve(ranks);
    return 0;
  }
  LammpsEngine engine(ranks);
  shared_engine = &engine;
  ::testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}

}  // namespace

LammpsEngine& engine_on_ranks() {
  return *shared_engine;
}

}  // namespace diefill::process::cluster

int main(int argc, char** argv) {
  MPI_Init(&argc, &argv);
  const int code = diefill::process::cluster::run_tests(argc, argv);
  MPI_Finalize();
  return code;
}
