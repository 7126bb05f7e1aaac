// Which spheres may come to touch: near pairs with a skin, renewed when motion has used the skin up. Motion
// is measured against the drift of the powder, so that powder in a moving shoe does not wear out its list.
// Where part of the powder falls or moves with the shoe and the rest does not, each part has a drift.
#pragma once

#include <array>
#include <optional>
#include <span>

#include "engine/numerics/thread_pool.h"
#include "engine/powder/sphere_field.h"
#include "engine/search/contact_history.h"
#include "engine/search/passing_speed.h"
#include "engine/search/search_workspace.h"
#include "engine/search/sphere_cells.h"
#include "engine/walls/walls.h"

namespace diefill::engine {

/// What the search needs to know.
struct NeighbourSettings {
  std::vector<double> sphere_radii;        ///< m, by class of spheres
  double farthest_sphere = 0;              ///< m, of a sphere's centre from its grain's centre, at most
  double law_range = 0;                    ///< m, gap up to which the law acts between grains
  std::vector<double> grain_history_sign;  ///< PairLoop::history_signs() of pairs of grains
  std::size_t wall_history = 0;            ///< numbers in the history of a touching pair with a wall
  std::size_t sum_numbers = ContactSum::kRolling;  ///< of a ContactSum that count
};

/// m, of a sphere of a grain or image.
inline double radius_of(const NeighbourSettings& settings, const SphereField& spheres, std::size_t sphere) {
  return settings.sphere_radii[settings.sphere_radii.size() == 1 ? 0 : spheres.class_of(sphere)];
}

/// The powder and the bodies as they stood when the list was made: all that is needed to determine when it is
/// too old, and to make it again.
struct ListReference {
  std::vector<Eigen::Vector3d> position;  ///< m, of grains
  std::vector<Quaternion> orientation;    ///< of grains of several spheres
  std::vector<BodyMotion> bodies;
  double skin = 0;  ///< m, how much nearer two slow spheres may come before the list must be renewed
  std::vector<std::uint8_t> doublings;  ///< of grains: how often half the skin is doubled for fast ones
  /// m, how far each body may move against the drift of the first group; then the same for the second, if
  /// any.
  std::vector<double> body_allowance;
  /// m/s, mean velocity of each group of grains.
  std::array<Eigen::Vector3d, 2> drift = {Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
  std::vector<std::uint8_t> group;  ///< of grains, 0 or 1; empty where all are in one
  double passing = 0;               ///< m, how far the two groups may drift past each other
  double time = 0;                  ///< s
  std::uint64_t step = 0;
  std::uint64_t awake_grains = 0;  ///< those from here on slept: they get blocks of their own

  std::size_t groups() const { return group.empty() ? 1 : 2; }
  std::size_t group_of(std::size_t k) const { return group.empty() ? 0 : group[k]; }
  /// m/s, of the second group against the first.
  double passing_speed() const { return group.empty() ? 0 : engine::passing_speed(drift); }
  /// m, how far body b may move against the drift of a group.
  double allowance_of_body(std::size_t b, std::size_t its_group) const {
    return body_allowance[its_group * bodies.size() + b];
  }
  /// m, how far grain k may move against the drift of its group before the list must be renewed.
  double allowance(std::size_t k) const { return allowance_of(doublings[k]); }
  /// m, the same of grains for which half the skin is doubled so often.
  double allowance_of(std::size_t often) const { return 0.5 * skin * static_cast<double>(1U << often); }
};

/// Near pairs in blocks.
class NeighbourList {
 public:
  /// `body_first`: number of the first wall sphere of each body when all are counted through.
  NeighbourList(const NeighbourSettings& settings, std::vector<std::uint32_t> body_first);

  /// Finds all near pairs, with the histories in `history` (sphere pairs) and `wall_history`.
  void build(const SphereField& spheres, const std::vector<WallBody>& bodies, const ListReference& reference,
             const ContactHistory& history, const ContactHistory& wall_history, ThreadPool& pool);

  std::vector<Block>& blocks() { return blocks_; }
  const std::vector<Block>& blocks() const { return blocks_; }
  /// Near pairs between grains.
  std::size_t near_pairs() const;
  const std::vector<std::uint32_t>& body_first() const { return body_first_; }
  const NeighbourSettings& settings() const { return settings_; }

  /// Where a grain's forces are summed outside its own block.
  struct ForeignSum {
    std::uint32_t block;
    std::uint16_t slot;   ///< of the block's sums
    std::uint16_t grain;  ///< counted from the first of its own block
  };
  /// Foreign sums of the grains of block b are [foreign_first()[b], foreign_first()[b + 1]), in the order of
  /// the blocks that hold them.
  const std::vector<std::uint32_t>& foreign_first() const { return foreign_first_; }
  const std::vector<ForeignSum>& foreign_sums() const { return foreign_sums_; }

  /// Blocks that cannot be finished before the pairs of block b are computed: itself and those whose grains
  /// these pairs meet.
  std::span<const std::uint32_t> waiting_for(std::size_t b) const {
    return {waiting_.data() + waiting_first_[b], waiting_first_[b + 1] - waiting_first_[b]};
  }
  /// For how many blocks block b waits in this sense.
  std::uint32_t awaited_by(std::size_t b) const { return awaited_[b]; }

 private:
  /// Spheres of similar size in cells that suit them: in cells for the largest, many small ones would have to
  /// be passed by. Where all grains are of one size there is one. Groups that drift past each other have
  /// cells of their own: only near the other group a search must reach farther.
  struct SizeLevel {
    double largest = 0;  ///< m, sphere radius
    std::array<SphereCells, 2> cells;
  };

  bool one_class() const { return settings_.sphere_radii.size() == 1; }
  void sort_into_cells(const SphereField& spheres, const ListReference& reference, ThreadPool& pool);
  void cut_into_blocks(std::size_t begin, std::size_t end, std::size_t grains_per_block);
  template <bool kMonodisperse>
  void find_grain_pairs(Block& block, const SphereField& spheres, const ListReference& reference,
                        const ContactHistory& history, SearchWorkspace& workspace) const;
  void find_wall_pairs(Block& block, const SphereField& spheres, const std::vector<WallBody>& bodies,
                       const ListReference& reference, const ContactHistory& history,
                       SearchWorkspace& workspace) const;
  void fill_wall_table(Block& block, const std::vector<std::uint32_t>& parts,
                       const ContactHistory& history) const;
  void number_spheres(Block& block, const SphereField& spheres) const;
  void index_foreign_sums();
  void note_waiting(std::vector<std::uint32_t>& homes);

  NeighbourSettings settings_;
  std::vector<std::uint32_t> body_first_;
  std::vector<Block> blocks_;
  std::size_t count_ = 0;          ///< blocks that have been cut so far
  std::vector<SizeLevel> levels_;  ///< by falling size
  std::vector<std::uint8_t> level_of_class_;
  std::vector<std::uint32_t> foreign_first_;
  std::vector<ForeignSum> foreign_sums_;
  std::vector<std::uint32_t> waiting_first_, waiting_, awaited_;
};

}  // namespace diefill::engine
