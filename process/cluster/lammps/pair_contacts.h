// The contacts of a rank as a pair style of LAMMPS: it asks for the list of near grains and adds the forces
// of all contacts, of walls as well, in its place of a step.
#pragma once

#include "process/cluster/lammps/lammps_api.h"

namespace diefill::process::cluster {

class PairContacts final : public LAMMPS_NS::Pair {
 public:
  static constexpr const char* kStyle = "diefill";

  explicit PairContacts(LAMMPS_NS::LAMMPS* lammps);
  ~PairContacts() override;
  PairContacts(const PairContacts&) = delete;
  PairContacts& operator=(const PairContacts&) = delete;

  void settings(int, char**) override {}
  void coeff(int, char**) override;
  void init_style() override;
  /// m, of the centres of grains of two types (from 1).
  double init_one(int type, int other) override;
  void compute(int, int) override;
};

}  // namespace diefill::process::cluster
