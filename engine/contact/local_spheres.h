// The spheres that a block's pairs are between, and the motion of their grains, copied side by side: what a
// contact needs lies together, in records that one vector load takes in.
#pragma once

#include <algorithm>
#include <vector>

#include "engine/numerics/prefetch.h"
#include "engine/numerics/transpose.h"
#include "engine/numerics/vector_instructions.h"
#include "engine/powder/posed_grains.h"
#include "engine/powder/sphere_field.h"
#include "engine/search/pair_table.h"

namespace diefill::engine {

/// What becomes of other blocks while one is computed: they wait, or threads finish them, which changes the
/// velocities and spins of their grains.
enum class OtherBlocks { wait, finish };

/// Spheres by their number in the block last taken in, grains by the number of their sum there
/// (Block::slot_of): single spheres and their grains have the same.
class LocalSpheres {
 public:
  /// m, centre of sphere k.
  Vector3 position(LocalSphere k) const {
    const Centre& centre = centres_[k];
    return {centre.value[0], centre.value[1], centre.value[2]};
  }
  /// m, the pair's own centre seen from the other one, and 0.
  void separate(GrainPair pair, Four& separation) const {
    Four other;
    load(separation, centres_[pair.own].value);
    load(other, centres_[pair.other].value);
    separation -= other;
  }
  /// Of a grain: velocity (m/s) in numbers 0 to 2, spin (rad/s) in numbers 4 to 6; the others are 0. The
  /// velocity is that of a single sphere's centre. Of a clumped grain it is what the rigid grain would have
  /// at the block's reference point, so that it is the same for all of its spheres.
  const Record& motion(std::size_t slot) const { return motion_[slot]; }
  /// m/s, as in motion().
  Vector3 velocity(std::size_t slot) const {
    const Record& motion = motion_[slot];
    return {motion.value[0], motion.value[1], motion.value[2]};
  }
  /// rad/s, angular velocity of a grain.
  Vector3 spin(std::size_t slot) const {
    const Record& motion = motion_[slot];
    return {motion.value[kSpin], motion.value[kSpin + 1], motion.value[kSpin + 2]};
  }

  /// Takes in the block's own spheres and their partners as they are now. `instructions`: all give the same.
  void take(const Block& block, const SphereField& spheres, InstructionSet instructions,
            OtherBlocks others = OtherBlocks::wait) {
    const std::size_t all = block.own_spheres() + block.partners.size();
    if (centres_.size() < all) centres_.resize(all);
    if (spheres.spheres_per_grain == 1) {
      if (others == OtherBlocks::finish)
        with_instructions(instructions, [&] { take_single<OtherBlocks::finish>(block, spheres); });
      else
        with_instructions(instructions, [&] { take_single<OtherBlocks::wait>(block, spheres); });
    } else {
      take_motion_about_reference(block, spheres);
      place_own(block, spheres, instructions);
      place_partners(block, spheres, instructions);
    }
  }

 private:
  /// A centre (m), with one number to spare.
  struct alignas(32) Centre {
    double value[4];
  };
  /// How many partners, and own grains, are prefetched ahead.
  static constexpr std::size_t kAhead = 16, kOwnAhead = kEntriesAhead<Eigen::Vector3d>;
  static constexpr std::size_t kSpin = 4;

  /// Grains are their spheres.
  template <OtherBlocks kOthers>
  void take_single(const Block& block, const SphereField& spheres) {
    const std::size_t own = block.own_spheres(), partners = block.partners.size();
    if (motion_.size() < own + partners) motion_.resize(own + partners);
    // Vectors are read together with the number after them, which the very last ones do not have.
    const std::size_t last = spheres.real() - 1;
    const auto put_sphere = [&](std::size_t k, std::size_t sphere) {
      if (sphere < last) {
        const SphereField::Single numbers = spheres.single(sphere);
        copy_three(numbers.centre, centres_[k].value);
        copy_motion<kOthers>(numbers.velocity, motion_[k].value);
        copy_motion<kOthers>(numbers.spin, motion_[k].value + kSpin);
      } else {
        put_centre(k, spheres.position(sphere));
        put_motion(k, spheres.motion(spheres.original(sphere)));
      }
    };
    for (std::size_t k = 0; k < own; ++k) {
      spheres.fetch(std::min(block.begin + k + kOwnAhead, last));
      put_sphere(k, block.begin + k);
    }
    for (std::size_t k = 0; k < partners; ++k) {
      // They lie anywhere: in a large bed in no cache.
      if (k + kAhead < partners) spheres.fetch(spheres.original(block.partners[k + kAhead]));
      put_sphere(own + k, block.partners[k]);
    }
  }

  void take_motion_about_reference(const Block& block, const SphereField& spheres) {
    const std::size_t own = block.grains();
    if (motion_.size() < own + block.seen.size()) motion_.resize(own + block.seen.size());
    const Vector3 reference = plain(block.reference);
    const auto put_moved = [&](std::size_t slot, const GrainMotion& motion, const Vector3& centre) {
      put_motion(slot, {motion.velocity + cross(motion.spin, reference - centre), motion.spin});
    };
    for (std::size_t k = 0; k < own; ++k) {
      const std::size_t grain = block.begin + k;
      spheres.fetch(std::min(grain + kOwnAhead, spheres.grains - 1));
      put_moved(k, spheres.motion(grain), spheres.grain_centre(grain));
    }
    for (std::size_t k = 0; k < block.seen.size(); ++k) {
      const std::size_t grain = block.foreign[k];
      if (k + kAhead < block.seen.size()) spheres.fetch(block.foreign[k + kAhead]);
      put_moved(own + k, spheres.motion(grain), spheres.grain_centre(grain) + spheres.shift(block.seen[k]));
    }
  }

  /// All spheres of the block's own grains.
  void place_own(const Block& block, const SphereField& spheres, InstructionSet instructions) {
    const std::size_t per_grain = spheres.spheres_per_grain;
    for (std::size_t first = 0; first < block.grains(); first += PosedGrains::kGrains) {
      const std::size_t count = std::min(PosedGrains::kGrains, block.grains() - first);
      const auto grain = [&](std::size_t lane) { return block.begin + first + std::min(lane, count - 1); };
      turn(count, spheres, grain, instructions);
      for (std::size_t number = 0; number < per_grain; ++number) {
        if (spheres.kind.empty()) {
          const Vector3 offset = spheres.offset(0, number);
          with_instructions(instructions, [&] { posed_.place_spheres(whole_groups(count), offset); });
        } else {
          for (std::size_t lane = 0; lane < whole_groups(count); ++lane)
            offset_.set(lane, spheres.offset(grain(lane), number));
          with_instructions(instructions, [&] { posed_.place_spheres(whole_groups(count), offset_); });
        }
        for (std::size_t lane = 0; lane < count; ++lane)
          put_centre((first + lane) * per_grain + number, posed_.place[lane]);
      }
    }
  }

  /// Of the other grains only those spheres that pairs meet.
  void place_partners(const Block& block, const SphereField& spheres, InstructionSet instructions) {
    const std::size_t own = block.own_spheres(), per_grain = spheres.spheres_per_grain;
    std::size_t k = 0;
    for (std::size_t first = 0; first < block.foreign.size(); first += PosedGrains::kGrains) {
      const std::size_t count = std::min(PosedGrains::kGrains, block.foreign.size() - first);
      const auto place = [&](std::size_t lane) { return first + std::min(lane, count - 1); };
      turn(
          count, spheres, [&](std::size_t lane) { return block.foreign[place(lane)]; }, instructions);
      for (std::size_t lane = 0; lane < count; ++lane) {
        const std::size_t grain = block.foreign[place(lane)], seen = block.seen[place(lane)];
        const Vector3 centre = posed_.centre[lane] + spheres.shift(seen);
        const Rotation to_laboratory = posed_.rotation(lane);
        for (; k < block.partners.size() && block.partners[k] / per_grain == seen; ++k)
          put_centre(own + k, centre + to_laboratory * spheres.offset(grain, block.partners[k] % per_grain));
      }
    }
  }

  /// Poses of `count` grains, `grain(lane)` each.
  template <class GrainOf>
  void turn(std::size_t count, const SphereField& spheres, const GrainOf& grain,
            InstructionSet instructions) {
    for (std::size_t lane = 0; lane < whole_groups(count); ++lane) {
      posed_.centre.set(lane, spheres.grain_centre(grain(lane)));
      posed_.orientation.set(lane, spheres.orientation(grain(lane)));
    }
    with_instructions(instructions, [&] { posed_.turn(whole_groups(count)); });
  }

  /// Three numbers of the four that are read, and 0.
  static void copy_three(const double* from, double* to) {
    Four numbers;
    load(numbers, from);
    drop_last(numbers);
    store(numbers, to);
  }
  /// The same for a velocity or spin: the number after it may be that of a grain that another thread moves.
  template <OtherBlocks kOthers>
  static void copy_motion(const double* from, double* to) {
    if constexpr (kOthers == OtherBlocks::wait) return copy_three(from, to);
    Four numbers;
    load_three(numbers, from);
    store(numbers, to);
  }
  void put_centre(std::size_t k, const Vector3& centre) { put(centre, centres_[k].value); }
  void put_motion(std::size_t slot, const GrainMotion& motion) {
    put(motion.velocity, motion_[slot].value);
    put(motion.spin, motion_[slot].value + kSpin);
  }
  /// Number by number: a vector that has just been computed cannot be read back as a whole at once.
  static void put(const Vector3& vector, double* value) {
    value[0] = vector.x;
    value[1] = vector.y;
    value[2] = vector.z;
  }

  std::vector<Centre> centres_;
  std::vector<Record> motion_;
  PosedGrains posed_;
  PosedGrains::Vectors offset_;
};

}  // namespace diefill::engine
