// A scene as typed, checked values in SI units: made from a TOML file by the reader, and all that a run
// needs.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/simulation/standard_gravity.h"
#include "process/input/scene_error.h"
#include "process/machine/step.h"
#include "process/machine/tool_spec.h"
#include "process/scene/economy.h"
#include "process/scene/powder/other_powders.h"
#include "process/scene/powder/powder_spec.h"
#include "process/scene/suction.h"

namespace diefill::process {

struct ContactSpec;

/// Which rule of coarse graining takes the reference powder to the wanted grain size.
enum class CoarseGraining { bierwisch };

/// R_eff of grains on a mesh: that of a flat wall,
/// or that on wall spheres, so that only the shape differs.
enum class MeshContactRadius { flat, wall_spheres };

/// Walls: spheres of one radius for all tools unless a tool says otherwise.
struct WallSpec {
  WallKind kind = WallKind::spheres;
  MeshContactRadius contact_radius = MeshContactRadius::flat;
  double sphere_radius = 1.5e-4;  ///< m, R_w
  double spacing = 1.6;           ///< over R_w; no grain passes at up to 15 m/s (engine/STABILITY.md, walls)
  double friction = 0.15;         ///< mu_w
  double work_of_adhesion = 0;    ///< J/m^2, w_w
};

/// Powder that begins as another run left it (pour.state; saved_state.h).
struct SavedState {
  std::filesystem::path directory;                         ///< of the other run's results
  double below = std::numeric_limits<double>::infinity();  ///< m, grains with their centre above are left out
};

/// Powder at the start: poured from a lattice in a box, up to `fill_height` above its floor once settled, or
/// the grains of a file or of another run, the box then being that about them. Copies of a scene carry the
/// place of such grains, not the grains.
struct PourSpec {
  Eigen::Vector3d lower = Eigen::Vector3d::Zero(), upper = Eigen::Vector3d::Zero();  ///< m, inside the shoe
  double fill_height = 0;  ///< m, wanted depth of the settled powder over the box's floor
  double solid_fraction =
      0;  ///< estimate of the settled solid fraction, sets the number of grains; 0: from the preset
  double rim_speed = 0.05;  ///< m/s of the initial random spin
  /// Over d; 0: 1.2, or wider so that the solid fraction of the lattice is at most 0.1 (Bierwisch 2009,
  /// section 3.2.1). Read as 2, with offsets of 0.5, for powder that would settle in columns.
  double lattice_constant = 0;
  double random_offset = 0.1;     ///< over d, uniform in +- per axis
  bool around_tools = false;      ///< places that a tool takes up are left out
  std::vector<PourLayer> layers;  ///< of several powders, from the floor up; empty: mixed by their shares
  std::optional<std::filesystem::path> grains_file;  ///< places of all grains, instead of the lattice
  std::optional<SavedState> state;                   ///< powder of another run, instead of the lattice
  int line = 0;
};

/// Lever arm of contact forces on clumped grains (Bierwisch OP-2).
enum class LeverArm { center, contact };
/// Whether the tangential spring is cut back to the Coulomb limit while sliding (Bierwisch OP-1).
enum class TangentialSpring { cut_back, free };
/// What an opening is measured between (Bierwisch OP-12): the spheres' surfaces, or their centres on the CAD
/// surface.
enum class OpeningMeasure { surfaces, centres };

/// What becomes of grains that tools wedge (engine/limits/pinched_grains.h).
enum class PinchedGrains { shear_off, stop };

/// How to compute.
struct NumericsSpec {
  double time_step_fraction = 0;    ///< of the critical step; 0: the default of engine/limits/time_step
  std::optional<double> time_step;  ///< s, given outright
  LeverArm lever_arm = LeverArm::contact;
  TangentialSpring tangential_spring = TangentialSpring::cut_back;
  OpeningMeasure opening = OpeningMeasure::surfaces;
  std::array<std::optional<double>, 3> period;  ///< m, periodic lengths, box centred on the origin
  PinchedGrains pinched_grains = PinchedGrains::shear_off;
  double most_sheared = 0.005;  ///< share of all grains poured that may be sheared off before the run stops
  double skin = 0;              ///< m, of the neighbour lists; 0: follows the motion of the powder
  double max_time = 0;          ///< s of simulated time allowed in all; 0: no limit
  double checkpoint_interval = 60;  ///< s of wall-clock time
};

/// What a probe records while the scene runs.
enum class ProbeQuantity { load, flow, filled_mass, fill_level, energy };

/// One probe.
struct ProbeSpec {
  std::string name;
  ProbeQuantity quantity = ProbeQuantity::load;
  std::string tool;  ///< of a load
  Eigen::Vector3d origin = Eigen::Vector3d::Zero(),
                  normal = -Eigen::Vector3d::UnitZ();  ///< m, plane of a flow; counts along the normal
  double interval = 1e-3;                              ///< s
};

/// The powder as results at one instant of the scene, or at several.
struct SnapshotSpec {
  std::string name;
  std::optional<Condition> when;  ///< nothing: when the poured powder has come to rest
  std::optional<double> every;    ///< s, again and again from then on
};

struct SectionSpec {
  std::string name;
  Eigen::Vector3d origin = Eigen::Vector3d::Zero(), normal = Eigen::Vector3d::UnitY();
};

/// A heap whose slope is measured: powder with its centre in the box.
struct HeapSpec {
  std::string name;
  Eigen::Vector3d from = Eigen::Vector3d::Zero(), to = Eigen::Vector3d::Zero();  ///< m, corners
};

/// What to measure when the powder is at rest.
struct MeasureSpec {
  std::optional<double> fill_plane;  ///< m, height that the cavity lies below; none: the top of the die
  double averaging_width = 0;        ///< m, sigma of Eq. 2.27; 0: the larger of 0.5 mm and d/2
  std::string width_place;  ///< where that stands, "file:line:column: measure.averaging_width"; may be empty
  int azimuth_bins = 36;
  double snapshot_interval = 0;       ///< s of simulated time between instants kept in the results; 0: none
  std::vector<SectionSpec> sections;  ///< empty: the plane through the cavity's axis along the shoe's motion
  std::vector<HeapSpec> heaps;
};

/// A value: copies are independent. They share `contact` and the steps, which are never changed; steps that
/// depend on the tools are prepared for a run in a copy (with_prepared_steps()).
struct Scene {
  std::filesystem::path file;
  std::string text;  ///< as read
  std::string title;
  std::uint64_t seed = 1;
  PowderSpec powder;
  std::vector<OtherPowder> other_powders;  ///< [[other_powder]]
  std::vector<PowderPair> powder_pairs;    ///< every pair of different powders, [powder] first
  CoarseGraining coarse_graining = CoarseGraining::bierwisch;
  std::shared_ptr<const ContactSpec> contact;  ///< [contact] (contact_spec.h); none: the powder's own law
  WallSpec walls;
  std::vector<ToolSpec> tools;
  PourSpec pour;
  std::vector<std::shared_ptr<const Step>> steps;
  std::vector<ProbeSpec> probes;
  std::vector<SnapshotSpec> snapshots;
  NumericsSpec numerics;
  MeasureSpec measure;
  EconomySpec economy;
  std::optional<SuctionSpec> suction;                           ///< none: air does not flow
  Eigen::Vector3d gravity = {0, 0, -engine::kStandardGravity};  ///< m/s^2
};

/// m, the smallest and the largest grain size wanted of all powders.
double smallest_grain(const Scene& scene);
double largest_grain(const Scene& scene);
/// m, of each particle type, powder after powder.
std::vector<double> grain_diameters(const Scene& scene);
/// Makes all grains of all powders larger by `factor`.
void enlarge(Scene& scene, double factor);

/// The filling strategy in one line, such as "2 passages at 0.2 m/s, then a wait of 0.05 s"; "no motion"
/// without steps.
std::string strategy_text(const Scene& scene);

/// Reads and checks a scene file: unknown keys, units, ranges, missing files. Throws SceneError for the first
/// fault found.
Scene read_scene(const std::filesystem::path& file);

/// Same from text; `file` stands in messages and resolves relative paths.
Scene parse_scene(const std::string& text, const std::filesystem::path& file);

}  // namespace diefill::process
