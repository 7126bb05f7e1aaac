#include "engine/contact/mesh_contacts.h"

namespace diefill::engine {

namespace {

/// Calls visit(sphere, first, end, touches) for the near pairs [first, end) of one sphere after the other,
/// and appends what touches.
template <class Visit>
DeepestOnMesh visit_spheres(const MeshPairs& near, MeshWorkspace& workspace, std::vector<WallTouch>& touches,
                            const Visit& visit) {
  const Block& block = near.block;
  DeepestOnMesh deepest;
  for (std::uint32_t r = block.wall_run_first[near.number]; r < block.wall_run_first[near.number + 1]; ++r) {
    const WallRun& run = block.wall_runs[r];
    const std::uint32_t end = block.wall_runs[r + 1].first;
    const double radius = near.radius_of(run.own);
    SphereOnMesh sphere(workspace, near.body, near.place_of(run.own), radius);
    const double within = run.within(plain(sphere.place()), sphere.reach());
    for (std::uint32_t p = run.first; p < end; ++p)
      if (block.wall_distance[p] < within) sphere.add_triangle(p, block.wall_pairs.pair[p].wall);
    const std::span<const TriangleTouch> touching = sphere.touches();
    for (const auto& touch : touching)
      touches.push_back({touch.near, near.class_of(run.own), touch.separation});
    deepest.overlap = std::max(deepest.overlap, sphere.deepest());
    deepest.over_radius = std::max(deepest.over_radius, sphere.deepest() / radius);
    visit(sphere, run.first, end, touching);
  }
  return deepest;
}

}  // namespace

DeepestOnMesh find_mesh_touches(const MeshPairs& near, MeshWorkspace& workspace,
                                std::vector<WallTouch>& touches) {
  return visit_spheres(near, workspace, touches, [](const auto&...) {});
}

DeepestOnMesh update_mesh_touches(PairTable<WallPair>& table, const MeshPairs& near, MeshWorkspace& workspace,
                                  std::vector<WallTouch>& touches) {
  return visit_spheres(near, workspace, touches,
                       [&](const SphereOnMesh& sphere, std::uint32_t first, std::uint32_t end,
                           std::span<const TriangleTouch> touching) {
                         note_triangle_touches(table, sphere, first, end, touching, workspace.touches_now);
                       });
}

}  // namespace diefill::engine
