// The result of a finished (or interrupted) filling: powder, tools, fields and figures, in SI units. Plain
// values. `process/measure` fills them, `result_file.h` stores and reads them, `render` draws them; none of
// the three needs the others.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace diefill::results {

/// Particle types of a powder of several sizes, or of several powders; arrays over types. Grains of all types
/// are of one shape, that of PowderState, unless `spheres` says otherwise.
struct ParticleTypes {
  std::vector<double> diameter;       ///< m, d
  std::vector<double> sphere_radius;  ///< m, R
  std::vector<double> mass;           ///< kg
  std::vector<double> solid_volume;   ///< m^3
  std::vector<std::string> material;  ///< name of the powder
  /// Where shapes differ: spheres of a grain of each type, and of all types one after the other their centres
  /// in the body frame (m) and their radii (m). Otherwise empty.
  std::vector<std::uint32_t> spheres;
  std::vector<Eigen::Vector3d> sphere_offsets;
  std::vector<double> sphere_radii;
  std::size_t size() const { return diameter.size(); }
};

/// The powder at one instant. Arrays run over grains (n) unless said otherwise. Where grains are of several
/// kinds, the four numbers of one grain are those of the grain of mean mass that was requested.
struct PowderState {
  double time = 0;                ///< s since the start of the scene
  double grain_diameter = 0;      ///< m, model grain size d (2R, 4R or 6R after the grain model)
  double sphere_radius = 0;       ///< m, radius R of the basic spheres
  double grain_mass = 0;          ///< kg
  double grain_solid_volume = 0;  ///< m^3, true solid volume (union of the spheres)
  std::vector<Eigen::Vector3d> sphere_offsets;  ///< m, sphere centres in the grain's body frame
  std::vector<double> sphere_radii;  ///< m, of the grain's spheres; empty where all are sphere_radius
  /// m, lengths of a box centred on the origin beyond which the same grains follow again; 0 where the powder
  /// ends.
  std::array<double, 3> period = {};
  std::vector<std::uint64_t> id;             ///< identity of the grain, kept through sorting and restarts
  std::vector<Eigen::Vector3d> position;     ///< m, grain centres, laboratory frame
  std::vector<Eigen::Vector4d> orientation;  ///< unit quaternion (w, x, y, z), body to laboratory
  std::vector<Eigen::Vector3d> velocity;     ///< m/s
  std::vector<Eigen::Vector3d> angular_velocity;  ///< rad/s, laboratory frame
  ParticleTypes kinds;                            ///< empty for powder of one size
  std::vector<std::uint8_t> kind;  ///< of every grain, its number in `kinds`; empty for powder of one size

  /// Not so where grains of several kinds have all gone: instants may still have them.
  bool monodisperse() const { return kinds.size() == 0; }
  double diameter_of(std::size_t k) const {
    return monodisperse() ? grain_diameter : kinds.diameter[kind[k]];
  }
  double sphere_radius_of(std::size_t k) const {
    return monodisperse() ? sphere_radius : kinds.sphere_radius[kind[k]];
  }
  /// Spheres of grain k, and of all grains.
  std::size_t spheres_of(std::size_t k) const {
    return kinds.spheres.empty() ? sphere_offsets.size() : kinds.spheres[kind[k]];
  }
  std::size_t sphere_count() const;
  /// m, of all spheres, in the order of sphere_centres().
  std::vector<double> radii_of_spheres() const;
  /// Place of the grain of every sphere, in the same order.
  std::vector<std::uint32_t> grains_of_spheres() const;
  /// Whether all spheres are of radius `sphere_radius`.
  bool equal_spheres() const { return monodisperse() && sphere_radii.empty(); }
  /// m, the largest of all.
  double largest_sphere_radius() const;
  double mass_of(std::size_t k) const { return monodisperse() ? grain_mass : kinds.mass[kind[k]]; }
  double solid_volume_of(std::size_t k) const {
    return monodisperse() ? grain_solid_volume : kinds.solid_volume[kind[k]];
  }
  double largest_diameter() const;  ///< m
  /// "1.88 mm", or "1.5 to 2.1 mm".
  std::string sizes_text() const;

  /// Centres of all spheres in the laboratory frame, grain after grain.
  std::vector<Eigen::Vector3d> sphere_centres() const;
};

/// Voronoi measure of every grain, in the order of PowderState. A cell cut short by the limit on cell size (a
/// free surface) is open: it has no meaningful volume and stays out of averages.
struct GrainSolidFraction {
  std::vector<double> cell_volume;      ///< m^3
  std::vector<double> solid_fraction;   ///< grain solid volume over cell volume
  std::vector<std::uint8_t> open;       ///< 1 where the cell reaches the free surface or found no cell
  std::vector<std::uint8_t> in_cavity;  ///< 1 where the grain centre lies in the cavity
};

/// What contacts carried through every grain at the time of the powder state, in the order of PowderState: J,
/// stress times the volume that a grain stands for, compression negative (Bierwisch 2009, Eq. 3.8, without
/// the part of the grains' own motion). Empty in older files.
struct ContactStress {
  std::vector<Eigen::Vector3d> normal;  ///< xx, yy, zz
  std::vector<Eigen::Vector3d> shear;   ///< yz, xz, xy: mean with their mirror images
};

/// A tool as it stood at the time of the powder state. Mesh in the laboratory frame (m).
struct ToolState {
  std::string name;
  std::string role;                                  ///< die, core, punch, shoe, plate
  std::vector<Eigen::Vector3d> vertices;             ///< m, laboratory frame
  std::vector<Eigen::Vector3i> triangles;            ///< counter-clockwise seen from outside
  std::vector<Eigen::Vector3d> wall_sphere_centres;  ///< m, laboratory frame
  double wall_sphere_radius = 0;                     ///< m
  std::string mesh_hash;                             ///< of the CAD file's bytes
};

/// What the CAD check and the covering with wall spheres found out about a tool.
struct ToolCheck {
  std::string tool;                   ///< name of the tool
  std::string file;                   ///< name of its CAD file, without folders
  std::vector<std::string> findings;  ///< about the mesh, one remark each; empty: nothing to remark upon
  double volume = 0;                  ///< m^3, enclosed by the mesh
  double mean_deviation = 0;          ///< m, of the wall spheres' envelope from the CAD surface
  double largest_deviation = 0;       ///< m, the same, largest
  double largest_gap = 0;             ///< m, largest gap between wall spheres
};

/// One stage of the schedule as it happened.
struct Stage {
  std::string tool;           ///< name of the tool that moved; empty: none did
  std::string words;          ///< for people, such as "1 passage at 0.2 m/s"
  double start = 0, end = 0;  ///< s since the start of the scene
};

/// Statements about the run, by topic, such as "powder" or "assumptions"; units are in the
/// texts. `name` and `text` have the same length.
struct Topic {
  std::string topic;
  std::vector<std::string> name, text;
};

/// Where the powder is collected. Rings have an axis and radii; other dies only the box.
struct CavityState {
  bool is_ring = false;
  Eigen::Vector3d axis_origin =
      Eigen::Vector3d::Zero();  ///< m, on the ring's axis (vertical) at the fill plane
  double inner_radius = 0;      ///< m, ring only: smallest inner radius
  double outer_radius = 0;      ///< m, ring only: largest outer radius
  Eigen::Vector3d lower_corner = Eigen::Vector3d::Zero();  ///< m, box around the cavity
  Eigen::Vector3d upper_corner = Eigen::Vector3d::Zero();  ///< m, its top is the fill plane
  double volume = 0;                                       ///< m^3 below the fill plane, 0 if unknown
  double narrowest_width = 0;                              ///< m, 0 if unknown
  /// Unit vector (horizontal) from the axis to azimuth 0: where the shoe first arrives.
  Eigen::Vector3d azimuth_zero = Eigen::Vector3d::UnitX();
};

/// A scalar field on a rectangular grid of (first, second) coordinates; NaN where there is no powder.
struct Field2D {
  std::string quantity;        ///< such as "solid fraction"
  std::string first_name;      ///< such as "azimuth"
  std::string first_unit;      ///< such as "deg"
  std::string second_name;     ///< such as "height"
  std::string second_unit;     ///< such as "mm"
  std::vector<double> first;   ///< node coordinates in first_unit
  std::vector<double> second;  ///< node coordinates in second_unit
  std::vector<double> value;   ///< value[j * first.size() + i] at (first[i], second[j])
  double averaging_width = 0;  ///< m, sigma of Eq. 2.27
};

/// A plane through the scene: origin, unit normal, and the in-plane axes that the field's coordinates run
/// along.
struct SectionPlane {
  std::string name;
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();  ///< m
  Eigen::Vector3d normal = Eigen::Vector3d::UnitY();
  Eigen::Vector3d first_axis = Eigen::Vector3d::UnitX();
  Eigen::Vector3d second_axis = Eigen::Vector3d::UnitZ();
};

/// A plane section of the solid-fraction field, coordinates in mm along the plane's axes from its origin.
struct SectionField {
  SectionPlane plane;
  Field2D field;
};

/// A curve, such as fill level against azimuth.
struct Profile {
  std::string quantity, unit;  ///< such as "fill level", "mm"
  std::string x_name, x_unit;  ///< such as "azimuth", "deg"
  std::vector<double> x, y;    ///< NaN where nothing was found
};

/// What a probe recorded while the scene ran: a table whose first column is the time.
struct ProbeSeries {
  std::string name;
  std::vector<std::string> columns, units;  ///< one a column
  std::vector<double> values;               ///< row after row
};

/// Statistics of the grains' solid fractions in the cavity (closed cells at least 2 d below the powder
/// surface).
struct SolidFractionSummary {
  double mean = 0;             ///< sum of solid volumes over sum of cell volumes (Bierwisch OP-11, primary)
  double arithmetic_mean = 0;  ///< plain mean of the grains' values
  double std = 0, min = 0, max = 0;
  double cv = 0;             ///< std over arithmetic mean
  std::uint64_t grains = 0;  ///< grains counted
};

/// The powder and the tools' places at an earlier instant of the run. Arrays over the grains there were, and
/// over FillResult::tools. In the laboratory frame where there is no die or it ends at its initial position,
/// else in the frame of the die at that time.
struct Instant {
  double time = 0;                                 ///< s since the start of the scene
  std::vector<std::uint64_t> id;                   ///< identity of the grain
  std::vector<Eigen::Vector3d> position;           ///< m
  std::vector<Eigen::Vector4d> orientation;        ///< unit quaternion (w, x, y, z), from the body
  std::vector<Eigen::Vector3d> velocity;           ///< m/s, relative to the laboratory
  std::vector<Eigen::Vector4d> tool_orientation;   ///< unit quaternion from the tool's place in FillResult
  std::vector<Eigen::Vector3d> tool_displacement;  ///< m, added after turning about the origin
  std::vector<std::uint8_t> kind = {};             ///< as PowderState::kind
};

/// Everything that describes one run. `figures` are the numbers of report.json at the top level; `texts` its
/// strings.
struct FillResult {
  std::string title;     ///< for people: strategy and powder
  std::string strategy;  ///< one line, such as "1 passage at 0.2 m/s"
  std::string powder_name;
  std::string scene_text;  ///< the scene file as read
  std::string program_version;
  std::uint64_t seed = 0;
  std::string state_hash;  ///< of the engine's final state
  PowderState powder;
  GrainSolidFraction solid_fraction;
  ContactStress contact_stress;
  std::vector<ToolState> tools;
  CavityState cavity;
  std::vector<CavityState> other_cavities;  ///< smaller ones; figures and maps are of `cavity`
  SolidFractionSummary summary;
  std::vector<Field2D> maps;  ///< cylindrical (azimuth, height) maps; empty for cavities that are no rings
  std::vector<SectionField> sections;
  std::vector<Profile> profiles;
  std::vector<Instant> instants;  ///< earlier times in rising order; empty unless the scene asks for them
  std::vector<ProbeSeries> probes;
  std::map<std::string, double> figures;        ///< grains, spheres, wall_spheres, steps, time_step_s, ...
  std::map<std::string, double> phase_seconds;  ///< the engine's phase timers
  std::vector<std::string> warnings;            ///< for people, such as "d over ring width is beyond 1/3"
  std::vector<ToolCheck> tool_checks;           ///< in the order of the tools
  std::vector<Stage> stages;                    ///< in the order of time
  std::vector<Topic> topics;                    ///< model, walls, assumptions, versions, ...
};

}  // namespace diefill::results
