// The grains of a rank as a fix of LAMMPS: it moves them in place of LAMMPS' integrators, sends their state
// and contact history along when they change ranks, and determines when near pairs must be searched again.
#pragma once

#include "process/cluster/lammps/lammps_api.h"
#include "process/cluster/lammps/rank_steps.h"

namespace diefill::process::cluster {

class FixGrains final : public LAMMPS_NS::Fix {
 public:
  static constexpr const char* kStyle = "diefill/grains";
  static constexpr const char* kId = "grains";

  FixGrains(LAMMPS_NS::LAMMPS* lammps, int count, char** words);
  ~FixGrains() override;
  FixGrains(const FixGrains&) = delete;
  FixGrains& operator=(const FixGrains&) = delete;

  /// The fix of this instance of LAMMPS.
  static FixGrains& of(LAMMPS_NS::LAMMPS& lammps);
  /// To be called once, before there are atoms.
  void attach(std::unique_ptr<RankSteps> steps);
  RankSteps& steps() { return *steps_; }

  int setmask() override;
  void initial_integrate(int) override;
  void pre_exchange() override;
  void setup_post_neighbor() override { post_neighbor(); }
  void post_neighbor() override;
  void pre_force(int) override;
  void final_integrate() override;

  void grow_arrays(int most) override;
  void copy_arrays(int from, int to, int) override;
  void set_arrays(int atom) override;
  int pack_exchange(int atom, double* numbers) override;
  int unpack_exchange(int atom, double* numbers) override;
  int pack_forward_comm(int count, int* atoms, double* numbers, int, int*) override;
  void unpack_forward_comm(int count, int first, double* numbers) override;

 private:
  void update_atom_views();
  void fetch_orientations();
  Eigen::Vector3d mean_velocity() const;

  std::unique_ptr<RankSteps> steps_;
};

}  // namespace diefill::process::cluster
