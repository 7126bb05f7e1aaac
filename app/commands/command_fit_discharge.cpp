#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "app/backup_notes.h"
#include "app/commands/commands.h"
#include "app/exit_code.h"
#include "app/options/choices.h"
#include "app/options/output_file.h"
#include "app/options/quantities.h"
#include "app/output.h"
#include "app/pictures/discharge_chart.h"
#include "app/pictures/drawing.h"
#include "app/tables/discharge_fit_report.h"
#include "app/tables/json_text.h"
#include "process/compare/backups.h"
#include "process/continuum/discharge_table.h"
#include "process/input/scene_error.h"
#include "process/results/storage/atomic_file.h"
#include "process/results/storage/file_contents.h"

namespace diefill::app {

namespace {

namespace continuum = process::continuum;
using continuum::DischargeLaw;

struct FitArguments {
  std::string file, law, density, width, length, shoe_length, grain_diameter, opened, until,
      out = "out/fit_discharge";
  bool json = false;
};

std::vector<std::string> law_names() {
  std::vector<std::string> names = {"4.1"};
  for (const DischargeLaw law : continuum::discharge_laws()) names.push_back(continuum::name_of(law));
  return names;
}

/// The law of that name; of none, the one that the table is for. Throws process::SceneError.
DischargeLaw wanted_law(const FitArguments& arguments) {
  if (arguments.law.empty()) return continuum::law_for_table(arguments.file);
  const std::string name = arguments.law == "4.1" ? "5.17" : arguments.law;  // one formula, two numbers
  for (const DischargeLaw law : continuum::discharge_laws())
    if (name == continuum::name_of(law)) return law;
  throw process::SceneError("--law: " + unknown_name(arguments.law, law_names()));
}

std::optional<double> quantity(const char* option, const std::string& text, process::Dimension dimension) {
  if (text.empty()) return std::nullopt;
  return positive_quantity(option, text, dimension);
}

continuum::CommonToAll common_of(const FitArguments& arguments) {
  using process::Dimension;
  return {quantity("--density", arguments.density, Dimension::density),
          quantity("--width", arguments.width, Dimension::length),
          quantity("--length", arguments.length, Dimension::length),
          quantity("--shoe-length", arguments.shoe_length, Dimension::length),
          quantity("--grain-diameter", arguments.grain_diameter, Dimension::length),
          quantity("--opened", arguments.opened, Dimension::time),
          quantity("--until", arguments.until, Dimension::time)};
}

continuum::DischargeFit fitted(const std::string& file, DischargeLaw law,
                               const continuum::DischargeData& data) {
  try {
    return continuum::fit_discharge(law, data);
  } catch (const std::invalid_argument& reason) {
    throw process::SceneError(file + ": law " + continuum::name_of(law) + ": " + reason.what());
  }
}

const std::vector<std::string> kFiles = {"fit.json", "fit.csv", "fit.png"};

/// Moves away what a fit of other data or another program has left under these names.
void keep_earlier_fit(const std::filesystem::path& out, const std::string& json) {
  if (results::contents_or_nothing(out / kFiles.front()) == json) return;
  if (const auto folder = process::back_up_files(out, kFiles))
    print_note("note: earlier files of these names were moved to " + folder->string());
}

int run_fit(const FitArguments& arguments) {
  const std::filesystem::path out = arguments.out;
  require_directory(out);
  require_other_files("--out", out, kFiles, {arguments.file});
  const DischargeLaw law = wanted_law(arguments);
  const auto data = continuum::read_discharge_table(arguments.file, law, common_of(arguments));
  const auto fit = fitted(arguments.file, law, data);
  const auto json = fit_as_json(fit, data, arguments.file);
  const OutputDirectory own(out);
  set_up_drawing();
  write_output([&] {
    const std::string text = json_text(json) + "\n";
    keep_earlier_fit(out, text);
    results::write_text_atomically(out / "fit.json", text);
    results::write_text_atomically(out / "fit.csv", fit_as_csv(fit, data));
    draw_discharge(out / "fit.png", fit, data);
  });
  if (arguments.json) {
    std::printf("%s\n", json_text(json).c_str());
    return kDone;
  }
  print_fit(fit, data);
  std::printf("numbers, points and chart in %s: fit.json, fit.csv, fit.png\n", out.string().c_str());
  return kDone;
}

}  // namespace

void add_fit_discharge(CLI::App& program, Action& chosen) {
  auto* command =
      program.add_subcommand("fit-discharge", "Fit a discharge law to measured masses, with uncertainty");
  auto arguments = std::make_shared<FitArguments>();
  command->add_option("FILE", arguments->file, "CSV file, units in its heading")->required();
  command->add_option("--law", arguments->law, "law to fit; 4.1 and 5.17 are one (default: by the columns)")
      ->check(one_of(law_names()));
  command->add_option("--density", arguments->density, "apparent density, such as '3.0 g/cm^3'");
  command->add_option("--width", arguments->width, "slit width along the shoe's travel, such as '6 mm'");
  command->add_option("--length", arguments->length, "slit length across the shoe's travel, such as '33 mm'");
  command->add_option("--shoe-length", arguments->shoe_length,
                      "inside length of the shoe along its travel, such as '32 mm'");
  command->add_option("--grain-diameter", arguments->grain_diameter,
                      "coarse grains: openings count as D - 1.4 d");
  command->add_option("--opened", arguments->opened,
                      "when the slit opened, such as '0.35 s': times count from then (default: from 0)");
  command->add_option("--until", arguments->until,
                      "law transient: leave out what was recorded after this time, such as '0.6 s', on the "
                      "clock of --opened: a hopper that is empty no longer shows how powder flows");
  command
      ->add_option("--out", arguments->out,
                   "directory for fit.json, fit.csv and fit.png; another fit's move to previous-1, ... in it")
      ->capture_default_str();
  command->add_flag("--json", arguments->json, "print fit.json too, SI units");
  command->footer(
      "Columns: speed m/s and mass g (laws 5.17, 5.18); time s and mass g, such as a flow probe's file "
      "(transient);\nrate g/s and diameter mm or width mm (Beverloo). Further columns: error g (one standard "
      "deviation), rate_error g/s,\nlength mm, shoe_length mm, density g/cm^3. The fit.json of 5.17, 5.18, "
      "transient and\nbeverloo-slit serves diefill estimate --discharge.\n"
      "Examples:\n  diefill fit-discharge masses.csv --density '3.0 g/cm^3' --width '6 mm' --length '33 mm' "
      "--shoe-length '32 mm'\n"
      "  diefill fit-discharge out/slit/probe_slit.csv --law transient --density '2.1 g/cm^3' --width '15 "
      "mm' "
      "--length '2.16 mm'");
  command->callback([arguments, &chosen] { chosen = [arguments] { return run_fit(*arguments); }; });
}

}  // namespace diefill::app
