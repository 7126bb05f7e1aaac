// LAMMPS on one rank: all ranks make the same calls at the same time. Arguments and results marked "on rank
// 0" are used there only; on other ranks they are ignored.
#pragma once

#include <memory>
#include <stdexcept>

#include "process/cluster/lammps/lammps_api.h"
#include "process/cluster/lammps/rank_steps.h"

namespace diefill::process::cluster {

/// LAMMPS is of a release that this code was not written for; thrown on all ranks.
struct OtherRelease : std::runtime_error {
  using std::runtime_error::runtime_error;
};

class RankEngine {
 public:
  /// Throws OtherRelease.
  explicit RankEngine(MPI_Comm ranks);
  ~RankEngine();
  RankEngine(const RankEngine&) = delete;
  RankEngine& operator=(const RankEngine&) = delete;

  int ranks() const { return count_; }
  int rank() const { return rank_; }
  MPI_Comm communicator() const { return communicator_; }
  /// Of LAMMPS, as 20210929.
  std::string release() const;

  /// Takes model, grains and contacts of a simulation; `simulation`: on rank 0.
  void load(const engine::Simulation* simulation);
  /// Runs steps. `motions`: on rank 0, the tools' poses at the end of each, step after step. Returns there
  /// what all ranks did.
  StepRecords run(std::size_t steps, const std::vector<engine::BodyMotion>& motions);
  /// On rank 0: all grains, in any order.
  engine::Grains grains();
  /// On rank 0: all touching pairs.
  engine::NamedContacts contacts_of_grains();
  engine::NamedContacts contacts_of_walls();
  /// On rank 0: how many grains each rank has.
  std::vector<std::uint64_t> shares();

  /// From rank 0 to all.
  Packet broadcast(const Packet& packet) const;

 private:
  /// To rank 0, in the order of the ranks; empty elsewhere.
  std::vector<Packet> gather(const Packet& packet) const;
  engine::NamedContacts gather(const engine::NamedContacts& contacts) const;
  void command(const std::string& words);
  void make_box(const PowderModel& model, const std::vector<Eigen::Vector3d>& places);
  void make_atoms(const engine::Grains& grains, const PowderModel& model);
  void put_states(const engine::Grains& grains, RankSteps& steps);
  void put_memory(const engine::NamedContacts& of_grains, const engine::NamedContacts& of_walls,
                  RankSteps& steps);

  MPI_Comm communicator_;
  int count_ = 1, rank_ = 0;
  std::unique_ptr<LAMMPS_NS::LAMMPS> lammps_;
  std::size_t bodies_ = 0;
  bool any_grains_ = false;
};

}  // namespace diefill::process::cluster
