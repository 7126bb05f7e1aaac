#include "process/cluster/lammps/pair_contacts.h"

#include "process/cluster/lammps/fix_grains.h"

namespace diefill::process::cluster {

PairContacts::PairContacts(LAMMPS_NS::LAMMPS* lammps) : Pair(lammps) {
  single_enable = 0;
  restartinfo = 0;
  no_virial_fdotr_compute = 1;
  finitecutflag = 1;
  centroidstressflag = LAMMPS_NS::CENTROID_NOTAVAIL;
}

PairContacts::~PairContacts() {
  if (allocated == 0) return;
  memory->destroy(setflag);
  memory->destroy(cutsq);
}

void PairContacts::coeff(int, char**) {
  const int types = atom->ntypes;
  if (allocated == 0) {
    memory->create(setflag, types + 1, types + 1, "pair:setflag");
    memory->create(cutsq, types + 1, types + 1, "pair:cutsq");
    allocated = 1;
  }
  for (int i = 1; i <= types; ++i)
    for (int j = 1; j <= types; ++j) setflag[i][j] = 1;
}

void PairContacts::init_style() {
  if (comm->ghost_velocity == 0 || force->newton_pair != 0)
    error->all(FLERR, std::string("pair style diefill needs newton off and velocities of ghosts"));
  neighbor->request(this, instance_me);
}

double PairContacts::init_one(int type, int other) {
  return FixGrains::of(*lmp).steps().model().reach(static_cast<std::size_t>(type - 1),
                                                   static_cast<std::size_t>(other - 1));
}

void PairContacts::compute(int, int) {
  ev_unset();
  // Forces at the start are those that the grains came with.
  if (update->setupflag != 0) return;
  FixGrains::of(*lmp).steps().add_forces();
}

}  // namespace diefill::process::cluster
