#include "process/powder/changed_scene.h"

#include "process/scene/contact_spec.h"

namespace diefill::process {
namespace {

/// Friction and adhesion put into a law of [contact]. The reader has refused laws without them.
void put(const std::optional<double>& friction, const std::optional<double>& work_of_adhesion,
         engine::laws::LawParameters& law) {
  if (friction) law.friction.set_friction(*friction);
  if (work_of_adhesion) law.normal.set_work_of_adhesion(*work_of_adhesion);
}

}  // namespace

Scene changed_scene(Scene scene, const PowderChange& change) {
  if (change.gravity) scene.gravity = *change.gravity;
  if (!change.changes_laws()) return scene;
  if (change.contact) scene.contact = change.contact;
  if (scene.contact) {
    ContactSpec contact = *scene.contact;
    put(change.friction, change.work_of_adhesion, contact.grains.law);
    put(change.wall_friction, change.wall_work_of_adhesion, contact.walls.law);
    scene.contact = std::make_shared<const ContactSpec>(std::move(contact));
    return scene;
  }
  if (change.friction) scene.powder.friction = *change.friction;
  if (change.work_of_adhesion) scene.powder.work_of_adhesion = *change.work_of_adhesion;
  if (change.wall_friction) scene.walls.friction = *change.wall_friction;
  if (change.wall_work_of_adhesion) scene.walls.work_of_adhesion = *change.wall_work_of_adhesion;
  return scene;
}

std::vector<Scene> changed_scenes(const Scene& scene) {
  std::vector<Scene> changed;
  for (const auto& step : scene.steps) {
    const PowderChange* change = step->change();
    if (change == nullptr) continue;
    changed.push_back(changed_scene(changed.empty() ? scene : changed.back(), *change));
  }
  return changed;
}

}  // namespace diefill::process
