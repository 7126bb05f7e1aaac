#include "process/powder/changed_scene.h"

#include <algorithm>

#include "process/scene/contact/contact_spec.h"

namespace diefill::process {
namespace {

/// Friction and adhesion put into a law of [contact]. The reader has refused laws without them.
void put(const std::optional<double>& friction, const std::optional<double>& work_of_adhesion,
         engine::laws::LawParameters& law) {
  if (friction) law.friction.set_friction(*friction);
  if (work_of_adhesion) law.normal.set_work_of_adhesion(*work_of_adhesion);
}

std::shared_ptr<const ContactSpec> changed(const ContactSpec& before, const PowderChange& change) {
  ContactSpec contact = before;
  put(change.friction, change.work_of_adhesion, contact.grains.law);
  put(change.wall_friction, change.wall_work_of_adhesion, contact.walls.law);
  return std::make_shared<const ContactSpec>(std::move(contact));
}

void put(const PowderChange& change, PowderSpec& powder) {
  powder.friction = change.friction.value_or(powder.friction);
  powder.work_of_adhesion = change.work_of_adhesion.value_or(powder.work_of_adhesion);
}

/// The same for the other powders and for pairs.
void change_others(Scene& scene, const PowderChange& change) {
  for (std::size_t k = 0; k < scene.other_powders.size(); ++k) {
    OtherPowder& other = scene.other_powders[k];
    put(change, other.powder);
    if (change.wall_friction) other.wall_friction = change.wall_friction;
    if (change.wall_work_of_adhesion) other.wall_work_of_adhesion = change.wall_work_of_adhesion;
    if (!change.contact_of_others.empty()) other.contact = change.contact_of_others.at(k);
    if (other.contact) other.contact = changed(*other.contact, change);
  }
  for (std::size_t k = 0; k < scene.powder_pairs.size(); ++k) {
    PowderPair& pair = scene.powder_pairs[k];
    put(change, pair.powder);
    if (!change.contact_of_pairs.empty()) pair.contact = change.contact_of_pairs.at(k);
    if (!pair.contact) continue;
    PairLawSpec law = *pair.contact;
    put(change.friction, change.work_of_adhesion, law.law);
    pair.contact = std::make_shared<const PairLawSpec>(std::move(law));
  }
}

}  // namespace

Scene changed_scene(Scene scene, const PowderChange& change) {
  if (change.gravity) scene.gravity = *change.gravity;
  if (!change.changes_laws()) return scene;
  if (change.contact) scene.contact = change.contact;
  change_others(scene, change);
  if (scene.contact) {
    scene.contact = changed(*scene.contact, change);
    return scene;
  }
  put(change, scene.powder);
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

double largest_gravity(const Scene& scene) {
  double largest = scene.gravity.norm();
  for (const auto& step : scene.steps)
    if (const PowderChange* change = step->change(); change != nullptr && change->gravity)
      largest = std::max(largest, change->gravity->norm());
  return largest;
}

}  // namespace diefill::process
