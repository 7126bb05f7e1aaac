// Options on how shaded views look, shared by the commands that draw them.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <utility>
#include <vector>

#include "render/scene3d/grain_view.h"
#include "render/scene3d/view_choice.h"

namespace diefill::app {

/// As the user gives them.
struct ViewArguments {
  std::string colour_by = "solid-fraction", tools = "cut", camera = "front";
  std::vector<double> range;
  int width = 1600;
  bool ambient_occlusion = false;
};

/// Adds --range, --colour-by, --tools, --camera, --renderer, --ambient-occlusion and --width.
void add_view_options(CLI::App& command, ViewArguments& arguments);

/// Limits of colour scales; NaN where none are given. Throws process::SceneError where they are not in order.
std::pair<double, double> range_of(const ViewArguments& arguments);

/// Numbers with commas between; empty where the text is anything else.
std::vector<double> numbers_in(const std::string& text);

/// A preset, or azimuth and elevation in degrees. Throws process::SceneError for anything else.
render::Camera camera_of(const std::string& text);

render::SceneLook look_of(const ViewArguments& arguments);

}  // namespace diefill::app
