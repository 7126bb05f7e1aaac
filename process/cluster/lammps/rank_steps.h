// The part of a step that a rank does for its grains, without LAMMPS: motion, near pairs, contact forces.
// FixGrains and PairContacts call it when LAMMPS comes to each.
#pragma once

#include <memory>

#include "engine/integrate/grain_integrator.h"
#include "process/cluster/lammps/step_records.h"

namespace diefill::process::cluster {

/// One rank's grains and what moves them.
class RankSteps {
 public:
  explicit RankSteps(PowderModel powder_model);
  RankSteps(const RankSteps&) = delete;
  RankSteps& operator=(const RankSteps&) = delete;

  const PowderModel& model() const { return model_; }
  RankGrains& grains() { return grains_; }
  const RankGrains& grains() const { return grains_; }

  /// Poses of the tools at the ends of the coming steps, step after step.
  void plan(std::vector<engine::BodyMotion> motions);
  /// Moves own grains to the end of the step; true where the neighbour list is too old for what follows.
  bool advance();
  /// Stores the history of touching pairs with own grains, which may move to another rank. Does nothing where
  /// that has been done.
  void store_history();
  /// Finds near pairs; `drift` (m/s): the powder's mean velocity, over all ranks.
  void search(const NearGrains& near, const Eigen::Vector3d& drift);
  /// Contact forces, with all spheres placed.
  void add_forces();
  /// Velocities at the end of the step.
  void finish();

  StepRecords& records() { return records_; }
  /// As ContactPass::history_signs().
  std::vector<double> grain_history_signs() const { return grain_pass_->history_signs(); }
  std::vector<double> wall_history_signs() const { return wall_pass_->history_signs(); }
  engine::NamedContacts contacts_of_grains() const { return named(*grain_pass_); }
  engine::NamedContacts contacts_of_walls() const { return named(*wall_pass_); }

 private:
  engine::NamedContacts named(const ContactPass& pass) const;
  double largest_displacement() const;
  bool tools_moved_far() const;
  double clearance_of(std::size_t body) const;

  PowderModel model_;
  RankGrains grains_;
  std::unique_ptr<ContactPass> grain_pass_, wall_pass_;
  engine::GrainIntegrator integrator_;
  engine::ContactSums sums_;
  ContactFigures figures_;
  StepRecords records_;
  std::vector<engine::BodyMotion> planned_;
  std::size_t step_ = 0;  ///< of those planned
  // Where all was at the last search.
  bool listed_ = false;
  std::vector<Eigen::Vector3d> place_then_;
  std::vector<engine::Quaternion> orientation_then_;
  std::vector<engine::BodyMotion> tools_then_;
  std::vector<double> clearance_;  ///< m, of each body from own grains
  Eigen::Vector3d drift_ = Eigen::Vector3d::Zero();
  double since_search_ = 0;  ///< s
  double remaining_ = 0;     ///< m, that any own sphere can still move before a search is needed
};

}  // namespace diefill::process::cluster
