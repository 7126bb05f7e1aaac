#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <tuple>

#include "app/commands/commands.h"
#include "app/commands/measured_pictures.h"
#include "app/commands/options_in_use.h"
#include "app/commands/shared_options/measured_region.h"
#include "app/commands/shared_options/view_options.h"
#include "app/exit_code.h"
#include "app/options/choices.h"
#include "app/options/numbers.h"
#include "app/options/quantities.h"
#include "app/options/results_directories.h"
#include "app/output.h"
#include "app/pictures/drawing.h"
#include "app/pictures/picture_kinds.h"
#include "app/pictures/source_names.h"
#include "process/input/unit_vector.h"
#include "process/measure/choose_cavity.h"
#include "process/measure/fields/measured_fields.h"
#include "process/measure/fields/time_average.h"
#include "process/results/formatted.h"
#include "process/results/storage/result_file.h"

namespace diefill::app {

namespace {

constexpr long long kMaxCavities = 1000000;

struct MapArguments {
  std::vector<std::string> directories, pictures, origin, measured, y;
  std::string x, out, averaging_width, normal, from, to;
  ViewArguments look;
  std::vector<std::string> given;  ///< of options_of_some_kinds()
  int cavity = 1;
  bool pdf = false, time_average = false;
};

/// s, --from and --to.
double time_of(const char* option, const std::string& text) {
  constexpr double kLongest = 1e6;  // s
  return bounded_quantity(option, text, process::Dimension::time, {0, kLongest, false, ""});
}

/// x, y, z, with or without sign, or three numbers such as 1,0,1.
Eigen::Vector3d normal_of(const std::string& text) {
  if (text.empty()) return Eigen::Vector3d::UnitY();
  if (const auto axis = process::axis_called(text)) return *axis;
  const auto numbers = numbers_in(text);
  if (numbers.size() == 3) {
    const Eigen::Vector3d given(numbers[0], numbers[1], numbers[2]);
    if (const auto normal = process::unit_vector(given)) return *normal;
  }
  throw process::SceneError(
      "--normal: found \"" + text +
      "\", allowed: x, y, z, or three numbers not all 0 and of sizes near 1, such as 1,0,1");
}

/// m, the same for all sources.
double width_for(const std::string& given, const std::vector<PictureSource>& sources) {
  std::vector<const results::FillResult*> results;
  for (const auto& source : sources) results.push_back(&source.result);
  return averaging_width_of(given, results);
}

/// The plane that the options give, else that of the first section of the first result; for all results.
void take_plane(PictureRequest& request, const MapArguments& arguments) {
  const auto& first = request.sources.front().result;
  request.plane_given = !arguments.origin.empty() || !arguments.normal.empty();
  const bool stored = !request.plane_given && !first.sections.empty();
  request.plane = stored ? first.sections.front().plane
                         : process::section_plane("section", section_origin(arguments.origin, first),
                                                  normal_of(arguments.normal));
}

/// Each source becomes the average of its instants from --from to --to.
void average_over_time(PictureRequest& request) {
  for (auto& source : request.sources) {
    const double from = request.from.value_or(0), to = request.to.value_or(source.result.powder.time);
    std::size_t instants = 0;
    try {
      source.result = process::time_average(source.result, from, to, &instants);
    } catch (const std::invalid_argument& error) {
      throw process::SceneError(std::string("--time-average: ") + error.what());
    }
    source.when = "mean of " + std::to_string(instants) + results::formatted(" instants, t = %.3f", from) +
                  results::formatted(" to %.3f s", to);
  }
}

/// Throws where --time-average goes with a kind that shows one instant.
void require_averages(const MapArguments& arguments) {
  if (!arguments.time_average) return;
  std::string allowed;
  for (const auto& kind : picture_kinds())
    if (kind.over_time == OverTime::average) allowed += std::string(" ") + kind.name;
  if (arguments.pictures.empty())
    throw process::SceneError("--time-average: found no --picture; give one of" + allowed);
  for (const auto& name : arguments.pictures)
    if (picture_kind(name).over_time != OverTime::average)
      throw process::SceneError("--time-average: found --picture " + name +
                                ", which shows one instant; allowed:" + allowed);
}

/// The result in a directory, as of the cavity that was asked for.
results::FillResult result_in(const std::string& directory, int cavity) {
  results::FillResult result = results::read_results(directory);
  try {
    process::choose_cavity(result, cavity);
  } catch (const std::invalid_argument& error) {
    throw process::SceneError("--cavity: " + std::string(error.what()) + " (" + directory + ")");
  }
  return result;
}

PictureRequest request_of(const MapArguments& arguments) {
  PictureRequest request;
  const auto names = source_names({arguments.directories.begin(), arguments.directories.end()});
  for (std::size_t k = 0; k < names.size(); ++k) {
    results::FillResult result = result_in(arguments.directories[k], arguments.cavity);
    std::string when = results::formatted("t = %.3f s", result.powder.time);
    request.sources.push_back({names[k], std::move(result), std::move(when)});
  }
  std::vector<ReadDirectory> read;
  for (std::size_t k = 0; k < request.sources.size(); ++k)
    read.push_back({arguments.directories[k], &request.sources[k].result});
  require_no_copies("DIR", read);
  request.out = arguments.out.empty() ? arguments.directories.front() : arguments.out;
  request.averaging_width = width_for(arguments.averaging_width, request.sources);
  take_plane(request, arguments);
  if (!arguments.from.empty()) request.from = time_of("--from", arguments.from);
  if (!arguments.to.empty()) request.to = time_of("--to", arguments.to);
  std::tie(request.lower, request.upper) = range_of(arguments.look);
  request.x = arguments.x;
  request.y = arguments.y;
  request.colour_by = arguments.look.colour_by;
  request.look = look_of(arguments.look);
  request.camera = camera_of(arguments.look.camera);
  request.width = arguments.look.width;
  request.pdf = arguments.pdf;
  if (arguments.time_average) average_over_time(request);
  return request;
}

/// The standard pictures of one result, as the run made them.
int standard_pictures(PictureRequest& request) {
  auto& result = request.sources.front().result;
  process::FieldRequest fields;
  fields.averaging_width = request.averaging_width;
  if (request.plane_given) fields.sections.push_back(request.plane);
  const int bins = result.profiles.empty() ? 36 : static_cast<int>(result.profiles.front().x.size());
  process::measure_fields(result, fields, bins);
  write_output([&] {
    for (const auto& picture : draw(request.out, result)) std::printf("%s\n", picture.string().c_str());
  });
  return kDone;
}

/// --x and --y alone select the chart of probes; with other kinds of picture they are refused.
void choose_probe_chart(MapArguments& arguments) {
  if (arguments.x.empty() && arguments.y.empty()) return;
  if (arguments.pictures.empty()) arguments.pictures.push_back("probe");
  if (std::find(arguments.pictures.begin(), arguments.pictures.end(), "probe") == arguments.pictures.end())
    throw process::SceneError("--x and --y: found --picture " + arguments.pictures.front() +
                              "; they choose columns of --picture probe");
}

/// Draws all that apply to the results. Throws SceneError, which names those that do not, when the others are
/// written.
void draw_each(const PictureRequest& request, const std::vector<std::string>& pictures) {
  std::string failed;
  for (const auto& name : pictures) {
    try {
      write_output([&] {
        for (const auto& picture : picture_kind(name).make(request))
          std::printf("%s\n", picture.string().c_str());
      });
    } catch (const std::invalid_argument& error) {
      failed += (failed.empty() ? "--picture " : "; --picture ") + name + ": " + error.what();
    }
  }
  if (!failed.empty()) throw process::SceneError(failed);
}

/// Throws where --measured goes with what it does not compare.
void require_one_result(const MapArguments& arguments) {
  if (arguments.measured.empty()) return;
  std::string found;
  if (arguments.directories.size() > 1)
    found = std::to_string(arguments.directories.size()) + " results directories";
  else if (!arguments.pictures.empty())
    found = "--picture " + arguments.pictures.front();
  else if (!arguments.x.empty() || !arguments.y.empty())
    found = arguments.x.empty() ? "--y" : "--x";
  if (found.empty()) return;
  throw process::SceneError("--measured: found " + found +
                            ", allowed: one results directory, without --picture, --x and --y");
}

int map(MapArguments arguments) {
  require_one_result(arguments);
  choose_probe_chart(arguments);
  require_averages(arguments);
  require_in_use(arguments.given, {arguments.pictures, !arguments.measured.empty(), arguments.time_average});
  const auto measured = process::read_measured_files(arguments.measured);
  if (!arguments.out.empty()) require_directory(arguments.out);
  if (arguments.pictures.empty() && arguments.directories.size() > 1)
    throw process::SceneError("several results directories: add --picture to choose what to draw");
  PictureRequest request = request_of(arguments);
  const DirectoryToFill filled(request.out);
  if (!arguments.measured.empty()) return draw_against_measured(request, measured);
  if (arguments.pictures.empty()) return standard_pictures(request);
  set_up_drawing();
  draw_each(request, arguments.pictures);
  return kDone;
}

std::string kinds_text() {
  std::string text = "Kinds of picture:\n";
  for (const auto& kind : picture_kinds()) {
    std::string name = kind.name;
    name.resize(18, ' ');
    text += "  " + name + kind.shows + "\n";
  }
  return text;
}

constexpr const char* kExamples =
    "Examples:\n"
    "  diefill map out/narrow_ring --averaging-width '1 mm'\n"
    "  diefill map out/narrow_ring --picture section --normal z --origin '0 mm' '0 mm' '-10 mm'\n"
    "  diefill map out/narrow_ring --measured fill_level.csv\n"
    "  diefill map out/twin_die --cavity 2 --out out/twin_die/cavity_2\n"
    "  diefill map out/one out/two --picture difference --picture height-profile --pdf --out out/compared\n"
    "  diefill map out/narrow_ring --picture displacement --from '0.2 s' --to '0.4 s'\n"
    "  diefill map out/slit --picture velocity-section --time-average --from '0.5 s' --to '0.6 s'\n"
    "  diefill map out/slow out/fast --y 'filled mass'\n"
    "  diefill map out/pressed --x 'press/shift z' --y 'press/force z'\n"
    "  diefill map out/narrow_ring --picture view --tools translucent --camera corner --width 3200";

/// Where the pictures are taken.
void add_place_options(CLI::App& command, MapArguments& arguments) {
  command
      .add_option(
          "--cavity", arguments.cavity,
          "cavity to draw, by its number in the report; use --out to keep the pictures of the largest")
      ->check(whole_number(1, kMaxCavities))
      ->capture_default_str();
  command.add_option("--averaging-width", arguments.averaging_width,
                     "Gaussian width sigma of the averaging, such as '1 mm' (default: that of the run's own "
                     "fields; of several DIR the largest)");
  command
      .add_option("--origin", arguments.origin, "point of the section plane, such as '0 mm' '0 mm' '-5 mm'")
      ->expected(3);
  command.add_option("--normal", arguments.normal,
                     "normal of the section plane: x, y, z, or three numbers such as 1,0,1 (default: plane "
                     "of the first section of the first DIR)");
}

/// When.
void add_time_options(CLI::App& command, MapArguments& arguments) {
  command.add_option("--from", arguments.from,
                     "time of an earlier instant, such as '0.2 s'; needs measure.snapshot_interval in the "
                     "scene");
  command.add_option("--to", arguments.to, "time of a later instant, or of the view (default: the end)");
  command.add_flag("--time-average", arguments.time_average,
                   "average over all stored instants between --from and --to");
}

/// Columns of probes to draw.
void add_probe_options(CLI::App& command, MapArguments& arguments) {
  command.add_option("--x", arguments.x,
                     "column of a probe along x, such as 'press/shift z' (default: the time)");
  command
      .add_option(
          "--y", arguments.y,
          "column of a probe to draw, such as 'press/force z' or 'zone rim/solid fraction'; several of "
          "one unit in one chart")
      ->allow_extra_args(false);
}

}  // namespace

void add_map(CLI::App& program, Action& chosen) {
  auto* command = program.add_subcommand(
      "map", "Draw pictures of results: maps, sections, differences, profiles, views, films");
  auto arguments = std::make_shared<MapArguments>();
  command->add_option("DIR", arguments->directories, "results directories of runs; several share one scale")
      ->required();
  command
      ->add_option("--picture", arguments->pictures, "kinds of picture, see below (default: those of a run)")
      ->check(one_of(picture_kind_names()))
      ->option_text("TEXT ...");
  command
      ->add_option("--measured", arguments->measured,
                   "CSV of a measured profile or map: draw it beside the result, with difference and "
                   "correlation zone by zone")
      ->allow_extra_args(false);
  command->add_option("--out", arguments->out, "directory for the pictures (default: the first DIR)");
  add_place_options(*command, *arguments);
  add_time_options(*command, *arguments);
  add_probe_options(*command, *arguments);
  add_view_options(*command, arguments->look);
  command->add_flag("--pdf", arguments->pdf, "also write charts as PDF");
  command->footer(kinds_text() + kExamples);
  command->callback([arguments, command, &chosen] {
    for (const auto& option : options_of_some_kinds())
      if (command->count(option) > 0) arguments->given.push_back(option);
    chosen = [arguments] { return map(*arguments); };
  });
}

}  // namespace diefill::app
