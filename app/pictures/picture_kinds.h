// The kinds of picture that `diefill map` makes, one registration each.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "process/run/assemble.h"
#include "render/scene3d/grain_view.h"
#include "render/scene3d/view_choice.h"

namespace diefill::app {

/// One results directory.
struct PictureSource {
  std::string name;  ///< the directory's, for legends and file names
  results::FillResult result;
  std::string when;  ///< for people: the time of the powder, or the times averaged over
};

/// What is wanted of the pictures. The first source is the one that others are compared with.
struct PictureRequest {
  std::vector<PictureSource> sources;
  std::filesystem::path out;
  double averaging_width = 0;      ///< m, the same for all sources
  results::SectionPlane plane;     ///< of sections, the same for all sources
  bool plane_given = false;        ///< by the user
  std::optional<double> from, to;  ///< s, instants to compare
  double lower, upper;             ///< of colour scales; NaN: from the data
  std::string colour_by;           ///< of shaded views
  std::string x;                   ///< column of a probe along x; empty: the time
  std::vector<std::string> y;      ///< columns of probes to draw; empty: those of the first probe
  render::SceneLook look;
  render::Camera camera;
  double width = 1600;  ///< pixels
  bool pdf = false;     ///< charts as PDF too
};

/// Whether a picture may show the powder of several instants at once (process/measure/fields/time_average.h).
enum class OverTime { one_instant, average };

/// Options that change the pictures of a kind; of others it has none.
struct UsedOptions {
  bool plane = false;             ///< --origin, --normal
  bool from = false, to = false;  ///< without --time-average
  bool range = false;             ///< of colours, or of the length of arrows
  bool look = false;              ///< --colour-by, --tools, --camera, --ambient-occlusion
};

/// A kind: its name on the command line, what it shows, and how it is made. Returns the files written. Throws
/// std::invalid_argument where the results do not hold what it needs.
struct PictureKind {
  const char* name;
  const char* shows;
  OverTime over_time;
  UsedOptions used;
  std::vector<std::filesystem::path> (*make)(const PictureRequest&);
};

/// All kinds. To add one: README.md of this folder.
const std::vector<PictureKind>& picture_kinds();
std::vector<std::string> picture_kind_names();

/// The kind of this name. Throws process::SceneError, naming the nearest, for any other.
const PictureKind& picture_kind(const std::string& name);

using Pictures = std::vector<std::filesystem::path>;
Pictures make_map(const PictureRequest& request);
Pictures make_plan_map(const PictureRequest& request);
Pictures make_fill_level_map(const PictureRequest& request);
Pictures make_partial_volume_map(const PictureRequest& request);
Pictures make_section(const PictureRequest& request);
Pictures make_difference(const PictureRequest& request);
Pictures make_displacement(const PictureRequest& request);
Pictures make_velocity_map(const PictureRequest& request);
Pictures make_velocity_section(const PictureRequest& request);
Pictures make_pressure_map(const PictureRequest& request);
Pictures make_pressure_section(const PictureRequest& request);
Pictures make_size_map(const PictureRequest& request);
Pictures make_size_section(const PictureRequest& request);
Pictures make_height_profile(const PictureRequest& request);
Pictures make_azimuth_profile(const PictureRequest& request);
Pictures make_histogram(const PictureRequest& request);
Pictures make_fill_level(const PictureRequest& request);
Pictures make_coordination(const PictureRequest& request);
Pictures make_probe_chart(const PictureRequest& request);
Pictures make_view(const PictureRequest& request);
Pictures make_frames(const PictureRequest& request);

}  // namespace diefill::app
