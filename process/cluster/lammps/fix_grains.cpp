#include "process/cluster/lammps/fix_grains.h"

#include <algorithm>

namespace diefill::process::cluster {

namespace {

/// Numbers sent with a grain besides its contact history: velocity, orientation, spin, force, torque, and the
/// length of the history.
constexpr int kState = 17;

double* put(const Eigen::Vector3d& vector, double* to) {
  return std::copy_n(vector.data(), 3, to);
}
const double* take(Eigen::Vector3d& vector, const double* from) {
  std::copy_n(from, 3, vector.data());
  return from + 3;
}

void copy(const Eigen::Vector3d& vector, double* to) {
  std::copy_n(vector.data(), 3, to);
}

}  // namespace

FixGrains::FixGrains(LAMMPS_NS::LAMMPS* lammps, int count, char** words) : Fix(lammps, count, words) {
  time_integrate = 1;
  force_reneighbor = 1;
  next_reneighbor = -1;
  comm_forward = 4;
  create_attribute = 1;
  maxexchange_dynamic = 1;
  maxexchange = kState;
  atom->add_callback(LAMMPS_NS::Atom::GROW);
}

FixGrains::~FixGrains() {
  atom->delete_callback(id, LAMMPS_NS::Atom::GROW);
}

FixGrains& FixGrains::of(LAMMPS_NS::LAMMPS& lammps) {
  const int place = lammps.modify->find_fix(kId);
  if (place < 0) throw std::logic_error("this LAMMPS instance has no fix diefill/grains");
  return static_cast<FixGrains&>(*lammps.modify->fix[place]);
}

void FixGrains::attach(std::unique_ptr<RankSteps> steps) {
  steps_ = std::move(steps);
  grow_arrays(atom->nmax);
}

int FixGrains::setmask() {
  using namespace LAMMPS_NS::FixConst;
  return INITIAL_INTEGRATE | PRE_EXCHANGE | POST_NEIGHBOR | PRE_FORCE | FINAL_INTEGRATE;
}

void FixGrains::initial_integrate(int) {
  int old = steps_->advance() ? 1 : 0, any = 0;
  const RankGrains& rank = steps_->grains();
  const bool clumps = rank.model.types.clumps();
  for (std::size_t k = 0; k < rank.own; ++k) {
    copy(rank.grains.position[k], atom->x[k]);
    copy(clumps ? engine::eigen(rank.motion.velocity[k]) : rank.grains.velocity[k], atom->v[k]);
    copy(clumps ? engine::eigen(rank.motion.spin[k]) : rank.grains.spin[k], atom->omega[k]);
  }
  MPI_Allreduce(&old, &any, 1, MPI_INT, MPI_MAX, world);
  next_reneighbor = any != 0 ? update->ntimestep : -1;
}

void FixGrains::pre_exchange() {
  steps_->store_history();
  std::size_t longest = 0;
  const auto own = static_cast<std::size_t>(atom->nlocal);
  for (std::size_t k = 0; k < own; ++k) longest = std::max(longest, steps_->grains().memory[k].size());
  maxexchange = kState + static_cast<int>(longest);
}

/// Updates which atoms this rank has now, and where.
void FixGrains::update_atom_views() {
  RankGrains& rank = steps_->grains();
  rank.own = static_cast<std::size_t>(atom->nlocal);
  rank.all = static_cast<std::size_t>(atom->nlocal + atom->nghost);
  const bool any = atom->nmax > 0;
  rank.place = any ? atom->x[0] : nullptr;
  rank.velocity = any ? atom->v[0] : nullptr;
  rank.spin = any ? atom->omega[0] : nullptr;
  rank.type = atom->type;
  rank.tag = atom->tag;
}

void FixGrains::post_neighbor() {
  update_atom_views();
  RankGrains& rank = steps_->grains();
  const bool clumps = rank.model.types.clumps();
  if (clumps) {
    rank.motion.velocity.resize(rank.own);
    rank.motion.spin.resize(rank.own);
  }
  if (!rank.model.types.monodisperse()) rank.motion.kind.resize(rank.own);
  for (std::size_t k = 0; k < rank.own; ++k) {
    rank.grains.id[k] = static_cast<std::uint64_t>(rank.tag[k] - 1);
    if (!rank.model.types.monodisperse()) rank.grains.kind[k] = rank.motion.kind[k] = rank.type_of(k);
    rank.grains.position[k] = engine::eigen(rank.centre(k));
    // Predicted ones have come along with the atoms.
    if (clumps) rank.motion.set_motion(k, {rank.velocity_of(k), rank.spin_of(k)});
  }
  fetch_orientations();
  rank.place_spheres();
  const LAMMPS_NS::NeighList& list = *force->pair->list;
  steps_->search({list.inum, list.ilist, list.numneigh, list.firstneigh}, mean_velocity());
}

void FixGrains::fetch_orientations() {
  RankGrains& rank = steps_->grains();
  if (!rank.model.types.clumps()) return;
  rank.orientation.resize(rank.all);
  for (std::size_t k = 0; k < rank.own; ++k) rank.orientation[k] = engine::plain(rank.grains.orientation[k]);
  comm->forward_comm_fix(this);
}

/// m/s, of all grains.
Eigen::Vector3d FixGrains::mean_velocity() const {
  const RankGrains& rank = steps_->grains();
  double sum[4] = {}, all[4] = {};
  for (std::size_t k = 0; k < rank.own; ++k)
    for (int axis = 0; axis < 3; ++axis) sum[axis] += atom->v[k][axis];
  sum[3] = static_cast<double>(rank.own);
  MPI_Allreduce(sum, all, 4, MPI_DOUBLE, MPI_SUM, world);
  return all[3] > 0 ? Eigen::Vector3d(all[0] / all[3], all[1] / all[3], all[2] / all[3])
                    : Eigen::Vector3d(Eigen::Vector3d::Zero());
}

void FixGrains::pre_force(int) {
  update_atom_views();
  fetch_orientations();
  steps_->grains().place_spheres();
}

void FixGrains::final_integrate() {
  steps_->finish();
}

void FixGrains::grow_arrays(int most) {
  if (!steps_) return;
  RankGrains& rank = steps_->grains();
  const auto count = static_cast<std::size_t>(most);
  rank.grains.resize(count, rank.model.types.clumps(), !rank.model.types.monodisperse());
  rank.memory.resize(count);
}

void FixGrains::copy_arrays(int from, int to, int) {
  RankGrains& rank = steps_->grains();
  const auto i = static_cast<std::size_t>(from), j = static_cast<std::size_t>(to);
  engine::Grains& grains = rank.grains;
  grains.velocity[j] = grains.velocity[i];
  if (!grains.orientation.empty()) grains.orientation[j] = grains.orientation[i];
  grains.spin[j] = grains.spin[i];
  grains.force[j] = grains.force[i];
  grains.torque[j] = grains.torque[i];
  rank.memory[j] = rank.memory[i];
}

void FixGrains::set_arrays(int atom_number) {
  RankGrains& rank = steps_->grains();
  const auto k = static_cast<std::size_t>(atom_number);
  engine::Grains& grains = rank.grains;
  grains.velocity[k].setZero();
  if (!grains.orientation.empty()) grains.orientation[k] = {1, 0, 0, 0};
  grains.spin[k].setZero();
  grains.force[k].setZero();
  grains.torque[k].setZero();
  rank.memory[k].clear();
}

int FixGrains::pack_exchange(int atom_number, double* numbers) {
  const RankGrains& rank = steps_->grains();
  const auto k = static_cast<std::size_t>(atom_number);
  const engine::Grains& grains = rank.grains;
  double* next = put(grains.velocity[k], numbers);
  const engine::Quaternion turn = grains.orientation_of(k);
  next = std::copy_n(turn.data(), 4, next);
  next = put(grains.spin[k], next);
  next = put(grains.force[k], next);
  next = put(grains.torque[k], next);
  const std::vector<double>& history = rank.memory[k];
  *next++ = static_cast<double>(history.size());
  return static_cast<int>(std::copy(history.begin(), history.end(), next) - numbers);
}

int FixGrains::unpack_exchange(int atom_number, double* numbers) {
  RankGrains& rank = steps_->grains();
  const auto k = static_cast<std::size_t>(atom_number);
  engine::Grains& grains = rank.grains;
  const double* next = take(grains.velocity[k], numbers);
  if (!grains.orientation.empty()) grains.orientation[k] = {next[0], next[1], next[2], next[3]};
  next = take(grains.spin[k], next + 4);
  next = take(grains.force[k], next);
  next = take(grains.torque[k], next);
  const auto count = static_cast<std::ptrdiff_t>(*next++);
  rank.memory[k].assign(next, next + count);
  return kState + static_cast<int>(count);
}

int FixGrains::pack_forward_comm(int count, int* atoms, double* numbers, int, int*) {
  double* next = numbers;
  for (int k = 0; k < count; ++k) {
    const engine::PlainQuaternion& q = steps_->grains().orientation[static_cast<std::size_t>(atoms[k])];
    for (const double number : {q.w, q.x, q.y, q.z}) *next++ = number;
  }
  return static_cast<int>(next - numbers);
}

void FixGrains::unpack_forward_comm(int count, int first, double* numbers) {
  for (int k = 0; k < count; ++k, numbers += 4)
    steps_->grains().orientation[static_cast<std::size_t>(first + k)] = {numbers[0], numbers[1], numbers[2],
                                                                         numbers[3]};
}

}  // namespace diefill::process::cluster
