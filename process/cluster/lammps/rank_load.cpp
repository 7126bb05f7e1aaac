// Loads a simulation on a rank: LAMMPS' box, one atom for each grain, and each grain's state and contact
// history.
#include <Eigen/Geometry>
#include <algorithm>
#include <unordered_map>

#include "process/cluster/lammps/fix_grains.h"
#include "process/cluster/lammps/grain_messages.h"
#include "process/cluster/lammps/memory_record.h"
#include "process/cluster/lammps/pair_contacts.h"
#include "process/cluster/lammps/rank_engine.h"
#include "process/results/formatted.h"

namespace diefill::process::cluster {

namespace {

std::string number(double value) {
  return results::formatted("%.17g", value);
}

template <class Style, class... Arguments>
auto* made(LAMMPS_NS::LAMMPS* lammps, Arguments... arguments) {
  return new Style(lammps, arguments...);  // LAMMPS owns its styles
}

/// LAMMPS forgets styles that are not its own with every `clear`.
void register_styles(LAMMPS_NS::LAMMPS& lammps) {
  (*lammps.force->pair_map)[PairContacts::kStyle] = [](LAMMPS_NS::LAMMPS* of) -> LAMMPS_NS::Pair* {
    return made<PairContacts>(of);
  };
  (*lammps.modify->fix_map)[FixGrains::kStyle] = [](LAMMPS_NS::LAMMPS* of, int count,
                                                    char** words) -> LAMMPS_NS::Fix* {
    return made<FixGrains>(of, count, words);
  };
}

}  // namespace

void RankEngine::load(const engine::Simulation* simulation) {
  Packet model_bytes, state;
  if (simulation != nullptr) {
    model_bytes = model_message(*simulation);
    put(state, simulation->grains());
    put(state, engine::grain_contacts(*simulation));
    put(state, engine::wall_contacts(*simulation));
    put(state, simulation->state().body_motion);
  }
  Packet received = broadcast(model_bytes);
  auto steps = std::make_unique<RankSteps>(read_model(received));
  state = broadcast(state);
  engine::Grains grains;
  engine::NamedContacts of_grains, of_walls;
  take(state, grains);
  take(state, of_grains);
  take(state, of_walls);
  take(state, steps->grains().body_motion);
  bodies_ = steps->model().bodies.size();
  any_grains_ = grains.size() > 0;
  command("clear");
  register_styles(*lammps_);
  if (!any_grains_) return;
  RankSteps& mine = *steps;
  make_box(mine.model(), grains.position);
  FixGrains::of(*lammps_).attach(std::move(steps));
  command("pair_style " + std::string(PairContacts::kStyle));
  command("pair_coeff * *");
  make_atoms(grains, mine.model());
  put_states(grains, mine);
  put_memory(of_grains, of_walls, mine);
  if (count_ > 1) command("fix shares all balance 1000 1.05 rcb");
  command("run 0 post no");
}

/// The box of LAMMPS: along axes without a period it grows with the powder, so that no grain ever leaves it,
/// and is never flat, for grains are sorted into its cells.
void RankEngine::make_box(const PowderModel& model, const std::vector<Eigen::Vector3d>& places) {
  Eigen::AlignedBox3d box;
  for (const auto& place : places) box.extend(place);
  const Eigen::Vector3d margin = Eigen::Vector3d::Constant(model.types.largest_grain());
  box = {box.min() - margin, box.max() + margin};
  std::string boundary, corners;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto& period = model.settings.period[axis];
    const auto k = static_cast<Eigen::Index>(axis);
    boundary += period ? " p" : " m";
    corners += ' ' + number(period ? -0.5 * *period : box.min()[k]) + ' ' +
               number(period ? 0.5 * *period : box.max()[k]);
  }
  for (const std::string& words :
       {std::string("units si"), std::string("newton off"), "boundary" + boundary,
        std::string("atom_style sphere"), std::string("atom_modify map hash"),
        std::string(count_ > 1 ? "comm_style tiled" : "comm_style brick"), std::string("comm_modify vel yes"),
        "region all block" + corners + " units box",
        "create_box " + std::to_string(model.types.size()) + " all",
        "neighbor " + number(model.skin) + " bin",
        // FixGrains says when; near grains of many sizes are many.
        std::string("neigh_modify delay 1000000000 every 1 check no one 20000 page 2000000"),
        "timestep " + number(model.settings.time_step), std::string("thermo_style custom step"),
        std::string("thermo 0"), "fix " + std::string(FixGrains::kId) + " all " + FixGrains::kStyle})
    command(words);
}

void RankEngine::make_atoms(const engine::Grains& grains, const PowderModel& model) {
  const std::size_t count = grains.size();
  const engine::PeriodicBox box(model.settings.period);
  std::vector<int> tag(count), type(count);
  std::vector<double> place(3 * count);
  for (std::size_t k = 0; k < count; ++k) {
    tag[k] = static_cast<int>(grains.id[k] + 1);
    type[k] = grains.type_of(k) + 1;
    const Eigen::Vector3d inside = box.wrapped(grains.position[k]);
    std::copy_n(inside.data(), 3, place.data() + 3 * k);
  }
  lammps_create_atoms(lammps_.get(), static_cast<int>(count), tag.data(), type.data(), place.data(), nullptr,
                      nullptr, 0);
  LAMMPS_NS::Atom& atom = *lammps_->atom;
  for (int k = 0; k < atom.nlocal; ++k) {
    const auto& shape = model.types.shape(static_cast<engine::TypeNumber>(atom.type[k] - 1));
    atom.radius[k] = shape.bounding_radius();
    atom.rmass[k] = shape.mass;
  }
}

/// Gives own grains their state.
void RankEngine::put_states(const engine::Grains& grains, RankSteps& steps) {
  LAMMPS_NS::Atom& atom = *lammps_->atom;
  engine::Grains& own = steps.grains().grains;
  std::vector<std::uint32_t> place(
      grains.id.empty() ? 0 : 1 + *std::max_element(grains.id.begin(), grains.id.end()));
  for (std::uint32_t k = 0; k < grains.size(); ++k) place[grains.id[k]] = k;
  for (int n = 0; n < atom.nlocal; ++n) {
    const auto k = static_cast<std::size_t>(n);
    const std::size_t from = place[static_cast<std::size_t>(atom.tag[n] - 1)];
    own.velocity[k] = grains.velocity[from];
    if (!grains.orientation.empty()) own.orientation[k] = grains.orientation[from];
    own.spin[k] = grains.spin[from];
    own.force[k] = grains.force[from];
    own.torque[k] = grains.torque[from];
    std::copy_n(grains.velocity[from].data(), 3, atom.v[n]);
    std::copy_n(grains.spin[from].data(), 3, atom.omega[n]);
  }
}

/// Gives own grains the history of their contacts.
void RankEngine::put_memory(const engine::NamedContacts& of_grains, const engine::NamedContacts& of_walls,
                            RankSteps& steps) {
  const LAMMPS_NS::Atom& atom = *lammps_->atom;
  std::unordered_map<std::uint64_t, std::size_t> place;
  for (int n = 0; n < atom.nlocal; ++n)
    place[static_cast<std::uint64_t>(atom.tag[n] - 1)] = static_cast<std::size_t>(n);
  const auto append = [&](std::uint64_t id, double partner, double own, double other, const double* history,
                          const std::vector<double>& width, bool turned) {
    const auto found = place.find(id);
    if (found != place.end())
      MemoryRecord::append(steps.grains().memory[found->second], partner, own, other, history, width.size(),
                           turned ? width.data() : nullptr);
  };
  const auto grain_signs = steps.grain_history_signs(), wall_signs = steps.wall_history_signs();
  const auto grain_history = with_width(of_grains, grain_signs.size());
  const auto wall_history = with_width(of_walls, wall_signs.size());
  for (std::size_t p = 0; p < of_grains.pair.size(); ++p) {
    const auto& pair = of_grains.pair[p];
    const double* history = grain_history.data() + p * grain_signs.size();
    append(pair.grain, static_cast<double>(pair.other + 1), pair.sphere, pair.other_sphere, history,
           grain_signs, false);
    append(pair.other, static_cast<double>(pair.grain + 1), pair.other_sphere, pair.sphere, history,
           grain_signs, true);
  }
  for (std::size_t p = 0; p < of_walls.pair.size(); ++p) {
    const auto& pair = of_walls.pair[p];
    std::uint64_t number = pair.other;
    std::size_t body = 0;
    for (; number >= steps.model().bodies[body].size(); ++body) number -= steps.model().bodies[body].size();
    append(pair.grain, MemoryRecord::body_key(body), pair.sphere, static_cast<double>(number),
           wall_history.data() + p * wall_signs.size(), wall_signs, false);
  }
}

}  // namespace diefill::process::cluster
