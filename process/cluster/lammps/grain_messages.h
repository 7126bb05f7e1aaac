// Grains, contacts and poses as bytes between ranks.
#pragma once

#include "engine/simulation/computed_step.h"
#include "engine/walls/walls.h"
#include "process/cluster/lammps/packet.h"

namespace diefill::process::cluster {

inline void put(Packet& packet, const engine::Grains& grains) {
  packet.put(grains.id);
  packet.put(grains.kind);
  for (const auto* vectors :
       {&grains.position, &grains.velocity, &grains.spin, &grains.force, &grains.torque})
    packet.put(*vectors);
  packet.put(grains.orientation);
}

inline void take(Packet& packet, engine::Grains& grains) {
  packet.take(grains.id);
  packet.take(grains.kind);
  for (auto* vectors : {&grains.position, &grains.velocity, &grains.spin, &grains.force, &grains.torque})
    packet.take(*vectors);
  packet.take(grains.orientation);
}

inline void put(Packet& packet, const engine::NamedContacts& contacts) {
  packet.put(contacts.pair);
  packet.put(contacts.history);
}

inline void take(Packet& packet, engine::NamedContacts& contacts) {
  packet.take(contacts.pair);
  packet.take(contacts.history);
}

/// Contact history of the pairs in `contacts`, `width` numbers each. Without friction the built-in engine
/// stores none, and the ranks store a spring without force.
inline std::vector<double> with_width(const engine::NamedContacts& contacts, std::size_t width) {
  if (contacts.history.size() == width * contacts.pair.size()) return contacts.history;
  return std::vector<double>(width * contacts.pair.size(), 0.0);
}

inline void put(Packet& packet, const std::vector<engine::BodyMotion>& motions) {
  std::vector<Eigen::Vector3d> vectors;
  for (const auto& motion : motions)
    vectors.insert(vectors.end(), {motion.rotation.col(0), motion.rotation.col(1), motion.rotation.col(2),
                                   motion.translation, motion.velocity, motion.angular_velocity});
  packet.put(vectors);
}

inline void take(Packet& packet, std::vector<engine::BodyMotion>& motions) {
  std::vector<Eigen::Vector3d> vectors;
  packet.take(vectors);
  constexpr std::size_t kVectors = 6;
  motions.resize(vectors.size() / kVectors);
  for (std::size_t k = 0; k < motions.size(); ++k) {
    const Eigen::Vector3d* of = vectors.data() + kVectors * k;
    motions[k].rotation << of[0], of[1], of[2];
    motions[k].translation = of[3];
    motions[k].velocity = of[4];
    motions[k].angular_velocity = of[5];
  }
}

}  // namespace diefill::process::cluster
