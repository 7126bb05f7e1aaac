// Answers that need no grain: how full a shoe leaves the cavities, how fast it may go, how often it must
// pass, whether air matters. Formulas on the tools' shapes, in well under a second.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "process/estimate/discharge/powder_discharge.h"
#include "process/estimate/openings/exposure.h"
#include "process/estimate/statements/known_error.h"
#include "process/estimate/work_of_steps.h"

namespace diefill::process::estimate {

/// What to estimate with.
struct EstimateOptions {
  std::optional<PowderDischarge> law;  ///< nothing: that of the scene's powder
  std::optional<double>
      particle_diameter;  ///< m, of the real powder, for air; nothing: [suction]'s or a guess
};

/// A share of what a cavity holds from which on it counts as full.
inline constexpr double kFull = 0.99;

/// One opening below the shoe.
struct OpeningEstimate {
  std::string name;        ///< "cavity"; of several "cavity 1", the largest, "cavity 2"; "slit"
  bool is_cavity = false;  ///< else powder runs right through
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();  ///< m, of a cavity
  double volume = 0, depth = 0;           ///< m^3, m (volume over area of the opening); 0 for a slit
  double area = 0;                        ///< m^2 of the opening
  double width = 0, effective_width = 0;  ///< m, of the opening; the same for grains of the scene's size
  double narrowest = 0;                   ///< m, width of a cavity over its height
  double full_mass = 0;                   ///< kg at apparent density; 0 for a slit
  std::vector<double> offered;            ///< kg that would run in, floor or not, by crossing
  std::vector<double> mass;               ///< kg in it after each crossing
  double least_mass = 0;                  ///< kg after all crossings with the error taken off
  double most_mass = 0;                   ///< kg, with the error added
  double share = 0;                       ///< of full_mass after all crossings
  double least_share = 0;                 ///< the same if the inflow is less by the error
  double most_share = 0;                  ///< the same if it is more
  double poured = 0;  ///< share of the opening that lies open below the powder that is poured
  /// Whether that powder runs out through a slit before it is at rest.
  bool runs_out() const { return !is_cavity && poured > 0 && effective_width > 0; }
  double too_fast = 0;  ///< share of the opening where, in the first crossing, flow has no time to begin
  std::optional<double> speed_once;  ///< m/s, fastest that fills it in one crossing
  std::optional<double> speed_all;   ///< m/s, the same in as many crossings as the scene has
  bool any_speed = false;            ///< it fills however fast the shoe goes, as that stands over it
  std::optional<int> crossings;      ///< needed at the scene's speed; nothing: more than kMaxCrossings
  std::optional<double> real_particle_share;       ///< share filled by particles of the powder's own size
  std::optional<double> real_particle_speed_once;  ///< m/s, speed_once of these
  /// sqrt(D / g), D the effective width, over the time that one portion of powder is over the opening: v_s /
  /// sqrt(g D) for a slit across the motion.
  double froude = 0;
  /// t sqrt(g/D) - 1/5 of the portion of powder that is longest over a place of the opening, in any crossing.
  double longest_x = 0;
  std::optional<double> air_escapes;  ///< s; nothing: particle size not known, or no air is trapped
  double air_trapped = 0;             ///< share of the time of all crossings in which powder covers it whole
  double air_ratio = 0;     ///< that share of the time that air needs, over the time of all crossings
  double filling_time = 0;  ///< s that powder covers it in the first crossing, mean
};
/// Share of the opening that counts as all of it.
inline constexpr double kWhole = 0.98;
inline constexpr int kMaxCrossings = 100;

/// A punch that falls under the shoe.
struct SuctionEstimate {
  FallingPunch punch;
  double volume_mass = 0;          ///< kg at apparent density in the room that it makes
  double covered = 0;              ///< share of that room that is made while powder stands over it
  double by_weight = 0;            ///< kg that follow by their own weight while it falls
  std::optional<double> with_air;  ///< kg, drawn by air as well; nothing: particle size not known
  std::optional<double> pull;      ///< drag of the air on powder at rest over its weight
  bool may_arch = false;           ///< narrow for these grains, and nothing breaks an arch
};

/// An opening that powder runs out of by itself, in a scene without a shoe.
struct OutletEstimate {
  double height = 0;  ///< m, z
  bool round = false;
  double width = 0;   ///< m, diameter of a round one, narrow side of a slit
  double length = 0;  ///< m, of a slit
  double rate = 0;    ///< kg/s, steady; 0: too narrow for these grains
  double mass = 0;    ///< kg above it at first
};

/// A number without unit that orders scenes.
struct SceneNumber {
  std::string name, meaning, source;
  double value = 0;
};

/// Powder and air as the estimate takes them.
struct PowderEstimate {
  double density = 0;                ///< kg/m^3, apparent
  bool density_is_estimate = false;  ///< not weighed
  double solid_fraction = 0;
  double in_shoe = 0;    ///< kg, poured
  double let_in = 0;     ///< kg, by steps that let powder in; infinite: as much as runs off
  double depth = 0;      ///< m, of all that in the shoe
  std::string name;      ///< of [powder]
  std::string left_out;  ///< names of the scene's other powders; empty: it has none
  std::optional<double> particle_diameter;  ///< m, of the real powder
  std::string particle_source;              ///< where that comes from
  double air_viscosity = 0;                 ///< Pa s
  std::optional<double> air_number;         ///< Ar rho_s / rho_air
  std::optional<double> carrying_flux;      ///< m/s
};

/// What the estimate settles.
enum class Answer {
  nothing_moves,
  too_fast,
  fills,
  open,
  no_formula,  ///< formulas do not hold for this scene: there are no openings and no numbers
  shut         ///< the shoe is closed: nothing runs in, and there are no openings either
};

struct Estimate {
  PowderEstimate powder;
  PowderDischarge law;
  double grain_diameter = 0;         ///< m
  double bond = 0;                   ///< Bond number of the powder at its own size
  ShoePath path;                     ///< without exposures
  std::optional<double> cycle_time;  ///< s, of the steps
  std::optional<Crossing> crossing;  ///< of the first passage
  std::vector<OpeningEstimate> openings;
  std::vector<SuctionEstimate> suctions;
  std::optional<OutletEstimate> outlet;
  bool only_shaken = false;  ///< tools are shaken or turned in place, and nothing else moves them
  std::vector<SceneNumber> numbers;
  std::vector<std::string> unseen;  ///< cavities that are not seen from above, with their places
  bool powder_limited = false;      ///< the shoe holds less than runs in: masses are cut down to it
  KnownError error;
  Answer answer = Answer::open;
  /// Why there is no answer, a clause each; empty: too close to call. Why nothing is estimated, or runs in.
  std::vector<std::string> open_because;
  bool is_estimated() const { return answer != Answer::no_formula && answer != Answer::shut; }
};

/// Estimates a scene on its tools; no wall spheres are needed. `scene` may have its steps prepared or not.
Estimate estimate(const Scene& scene, const Tooling& tooling, const EstimateOptions& options = {});

/// One statement for people.
struct Statement {
  std::string topic;   ///< "filling", "air", ...
  std::string words;   ///< with numbers and what to do
  std::string source;  ///< of the formula
  std::string valid;   ///< range
  std::string error;   ///< against DEM, or "not measured"
};

/// All statements, the answer first.
std::vector<Statement> statements(const Estimate& estimate);
/// The answer, and the one or two lines that it rests on.
std::vector<std::string> in_short(const Estimate& estimate);

}  // namespace diefill::process::estimate
