#include "engine/simulation/block_forces.h"

namespace diefill::engine {

void compute_block(SimulationState& state, std::size_t b, BlockWorkspace& workspace, OtherBlocks others) {
  Block& block = state.list.blocks()[b];
  const InstructionSet instructions = state.settings.instructions;
  workspace.spheres.take(block, state.spheres, instructions, others);
  const ContactScene scene = contact_scene(state, workspace.spheres);
  state.tallies[b].start(state.bodies.size());
  std::vector<ContactSum>& sums = workspace.contact.sums;
  if (sums.size() < block.sums.size()) sums.resize(block.sums.size());
  state.grain_loop->add_forces(block, scene, workspace.contact, state.tallies[b]);
  state.wall_loop->add_forces(block, scene, workspace.contact, state.tallies[b]);
  with_instructions(instructions, [&] { block.sums.keep(sums); });
}

}  // namespace diefill::engine
