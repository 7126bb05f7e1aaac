#include "app/commands/lab_experiments.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <memory>
#include <thread>

#include "app/backup_notes.h"
#include "app/commands/film_command.h"
#include "app/commands/live_jobs.h"
#include "app/exit_code.h"
#include "app/options/choices.h"
#include "app/options/numbers.h"
#include "app/options/output_file.h"
#include "app/output.h"
#include "app/own_command.h"
#include "app/pictures/drawing.h"
#include "app/stop_signals.h"
#include "app/tables/lab_table_text.h"
#include "process/compare/backups.h"
#include "process/input/sample_tools.h"
#include "process/input/scene_error.h"
#include "process/input/shell_word.h"
#include "process/laboratory/published/comparisons.h"
#include "process/laboratory/published/family_tables.h"
#include "process/laboratory/published/fidelity.h"
#include "process/laboratory/published/kept_results.h"
#include "process/laboratory/published/lab_folder.h"
#include "process/laboratory/published/lab_powder.h"
#include "process/laboratory/published/other_figures.h"
#include "process/laboratory/published/perform.h"
#include "process/results/figure_table.h"
#include "process/results/storage/atomic_file.h"
#include "render/charts/experiment_chart.h"
#include "render/report/html.h"
#include "render/report/lab_report.h"
#include "render/report/pdf.h"

namespace diefill::app {

namespace {

namespace fs = std::filesystem;
namespace laboratory = process::laboratory;

constexpr const char* kRemarks = "remarks.csv";
constexpr const char* kComparisons = "comparisons.csv";
constexpr const char* kPages = "../../process/laboratory";  // seen from the scenes
constexpr const char* kSheet = "powder_sheet";
constexpr const char* kWithFilms = "wire_sawing";  // whose runs keep their grains over time
constexpr const char* kSizes[] = {"coarse", "medium", "published"};

struct LabArguments {
  std::string size = "coarse", out, powder, scenes, page;
  int seeds = 1, jobs = 1;
  double budget = 0;  ///< core minutes; 0: no limit
  bool quiet = false, collect = false, film = false, prints_tables = true;
};

fs::path scenes_folder(const std::string& wanted) {
  return wanted.empty() ? laboratory::laboratory_folder() : fs::path(wanted);
}

laboratory::LabSize size_of(const std::string& name) {
  if (name == kSizes[0]) return laboratory::LabSize::coarse;
  return name == kSizes[1] ? laboratory::LabSize::medium : laboratory::LabSize::published;
}

laboratory::LabSetting setting_of(const LabArguments& arguments) {
  laboratory::LabSetting setting;
  setting.size = size_of(arguments.size);
  setting.scenes = scenes_folder(arguments.scenes);
  setting.powder = arguments.powder;
  return setting;
}

laboratory::LabJobs jobs_of(const LabArguments& arguments, const fs::path& directory) {
  laboratory::LabJobs jobs;
  jobs.directory = directory;
  jobs.seeds = arguments.seeds;
  jobs.on_note = print_note;
  jobs.run = !arguments.collect;
  jobs.options.program = fs::read_symlink("/proc/self/exe");
  jobs.options.at_once = arguments.jobs;
  jobs.options.cores = arguments.jobs;
  jobs.options.pictures = false;
  jobs.options.share_starts = true;
  if (arguments.budget > 0) jobs.options.cpu_seconds = 60 * arguments.budget;
  jobs.options.show_progress = !arguments.quiet;
  jobs.options.stop = &install_stop_handlers();
  jobs.options.watch = live_jobs(directory, "Laboratory: " + directory.parent_path().filename().string());
  return jobs;
}

/// Folders are called by the names of powder files, which may be the same: tables of another powder are moved
/// away.
void keep_tables_of_other_powder(const fs::path& directory, const laboratory::SceneExperiment& experiment,
                                 const LabArguments& arguments) {
  if (arguments.powder.empty()) return;
  write_output([&] {
    if (laboratory::holds_runs_of_other_scenes(experiment, setting_of(arguments), directory, arguments.seeds))
      note_moved_results(process::back_up_tables(directory));
  });
}

/// Runs it into `directory`, prints its table where the arguments say so, and writes it and its charts.
laboratory::LabOutcome perform_into(const fs::path& directory, const laboratory::SceneExperiment& experiment,
                                    const LabArguments& arguments) {
  const auto setting = setting_of(arguments);
  const auto figures = laboratory::read_published_figures(setting.scenes / laboratory::kPublishedFigures);
  make_output_directory(directory);
  const OutputDirectory output(directory, {"tools", "beginnings"});
  keep_tables_of_other_powder(directory, experiment, arguments);
  laboratory::LabOutcome outcome;
  write_output(
      [&] { outcome = laboratory::perform(experiment, setting, figures, jobs_of(arguments, directory)); });
  if (arguments.prints_tables) std::printf("%s", lab_table_text(outcome.table).c_str());
  std::fflush(stdout);
  write_output([&] {
    results::write_lab_table(directory, outcome.table);
    for (const auto& chart : outcome.charts) {
      if (chart.series.empty()) continue;
      results::write_chart(directory, chart);
      render::draw_experiment(directory, chart);
    }
  });
  return outcome;
}

/// DIR/<experiment>/<size>; of another powder with its name appended.
fs::path folder_of(const fs::path& all, const std::string& experiment, const LabArguments& arguments) {
  std::string size = arguments.size;
  if (!arguments.powder.empty()) size += "_" + fs::path(arguments.powder).stem().string();
  return all / experiment / size;
}

fs::path all_of(const LabArguments& arguments) {
  return arguments.out.empty() ? fs::path("out/lab") : fs::path(arguments.out);
}

/// Films of the experiment's own runs that kept their grains over time, as <run>.mp4; without --film the
/// command that makes one.
void make_films(const fs::path& directory, const laboratory::SceneExperiment& one,
                const LabArguments& arguments) {
  for (const auto& run : one.plan(setting_of(arguments)).custom_runs) {
    const fs::path results = directory / run.name / "seed-1";
    if (!fs::exists(results / "results.h5")) continue;
    if (arguments.film && !arguments.quiet) std::fprintf(stderr, "film of %s\n", run.name.c_str());
    if (arguments.film)
      make_film(results, directory / (run.name + ".mp4"), "diameter");
    else
      std::printf("film of %s: %s film %s --colour-by diameter\n", run.name.c_str(), own_command().c_str(),
                  process::shell_word(results.string()).c_str());
  }
}

int experiment(const laboratory::SceneExperiment& one, const LabArguments& arguments) {
  laboratory::require_use_of_powder(one, setting_of(arguments));
  set_up_drawing();
  const fs::path directory = folder_of(all_of(arguments), one.name, arguments);
  const laboratory::LabOutcome outcome = perform_into(directory, one, arguments);
  const bool drawn = std::any_of(outcome.charts.begin(), outcome.charts.end(),
                                 [](const auto& chart) { return !chart.series.empty(); });
  std::printf("in %s: %s.csv, %s.json%s\n", directory.string().c_str(), one.name.c_str(), one.name.c_str(),
              drawn ? ", charts" : "");
  make_films(directory, one, arguments);
  for (const auto& row : outcome.table.rows)
    if (row.values.empty()) return kFailed;
  return kDone;
}

/// The tables below `all`, coarse ones first.
std::vector<results::LabTable> tables_below(const fs::path& all) {
  std::vector<results::LabTable> tables;
  for (const char* size : kSizes)
    for (const auto& one : laboratory::scene_experiments())
      if (fs::exists(all / one.name / size / (one.name + ".json")))
        tables.push_back(results::read_lab_table(all / one.name / size, one.name));
  return tables;
}

/// Where the page goes unless --page says so: into the source tree of the scenes, else to `all`.
fs::path default_page(const fs::path& scenes, const fs::path& all) {
  const fs::path pages = scenes / kPages;
  const bool ours = process::in_source_tree(scenes / "..") && ::access(pages.c_str(), W_OK) == 0;
  return (ours ? fs::weakly_canonical(pages) : all) / "FIDELITY.md";
}

int fidelity(const LabArguments& arguments) {
  set_up_drawing();
  const fs::path scenes = scenes_folder(arguments.scenes), all = all_of(arguments);
  const auto figures = laboratory::read_published_figures(scenes / laboratory::kPublishedFigures);
  const fs::path page = arguments.page.empty() ? default_page(scenes, all) : fs::path(arguments.page);
  const OutputFile file = {"--page", page, {".md"}};
  require_output_file(file,
                      {scenes / laboratory::kPublishedFigures, scenes / kRemarks, scenes / kComparisons});
  require_directory(all);
  make_directory_of(file);
  const fs::path values = page.parent_path() / laboratory::kKeptResults;
  const fs::path other_values = page.parent_path() / laboratory::kOtherFigures;
  auto kept = laboratory::read_kept_results(values, figures);
  auto others = laboratory::read_other_figures(other_values);
  for (const auto& one : laboratory::scene_experiments())
    if (one.name != kSheet) perform_into(folder_of(all, one.name, arguments), one, arguments);
  const auto measured = tables_below(all);
  laboratory::take_over(kept, measured);
  laboratory::take_over(others, measured);
  auto tables = laboratory::tables_with_kept(kept, measured);
  for (auto& table : laboratory::family_tables(scenes / kPages)) tables.push_back(std::move(table));
  tables.push_back(laboratory::compared_figures(scenes / kComparisons, figures));
  write_output([&] {
    results::write_text_atomically(values, laboratory::csv_of(kept));
    results::write_text_atomically(other_values, laboratory::csv_of(others));
    results::write_text_atomically(page.parent_path() / laboratory::kOtherFiguresPage,
                                   laboratory::other_figures_page(others));
    results::write_text_atomically(
        page, laboratory::fidelity_page(figures, tables, laboratory::read_remarks(scenes / kRemarks)));
  });
  std::printf("%zu published figures in %s, values in %s\n", figures.size(), page.string().c_str(),
              values.string().c_str());
  return kDone;
}

/// The data sheet of one powder: table, charts, HTML and PDF.
int powder_sheet(const LabArguments& arguments) {
  set_up_drawing();
  const auto& all = laboratory::scene_experiments();
  const auto sheet = std::find_if(all.begin(), all.end(), [](const auto& one) { return one.name == kSheet; });
  const fs::path directory = folder_of(all_of(arguments), kSheet, arguments);
  const auto outcome = perform_into(directory, *sheet, arguments);
  const auto document = render::report::powder_sheet(outcome.table, outcome.charts);
  write_output([&] {
    results::write_text_atomically(directory / "data_sheet.html", render::report::html_page(document));
    results::write_text_atomically(directory / "data_sheet.pdf", render::report::pdf_pages(document));
  });
  std::printf("in %s: data_sheet.html, data_sheet.pdf, %s.json\n", directory.string().c_str(), kSheet);
  return outcome.finished ? kDone : kFailed;
}

void add_options(CLI::App& command, LabArguments& arguments) {
  command
      .add_option("--size", arguments.size,
                  "coarse: 4 times the published grain size; medium: twice; published")
      ->check(one_of({"coarse", "medium", "published"}));
  command.add_option("--seeds", arguments.seeds, "packings with consecutive seeds (default: 1)")
      ->check(whole_number(1, 1000));
  command.add_option("--budget", arguments.budget, "core minutes per experiment; skipped runs are listed")
      ->check(number_above_zero());
  command.add_option("--jobs", arguments.jobs, "runs at a time, one core each (default: 1)")
      ->check(whole_number(1, 1024));
  command.add_option("--out", arguments.out, "folder of all experiments (default: out/lab)");
  command.add_option(
      "--scenes", arguments.scenes,
      "folder of the laboratory's scenes (default: sample_tools/laboratory that comes with the program)");
  command.add_flag("--collect", arguments.collect, "do not run: only what is finished");
  command.add_flag("--quiet", arguments.quiet, "print no progress");
}

void add_experiment(CLI::App& lab, const laboratory::SceneExperiment& one, Action& chosen) {
  auto* command = lab.add_subcommand(one.name, results::capitalised(one.question));
  auto arguments = std::make_shared<LabArguments>();
  add_options(*command, *arguments);
  command
      ->add_option("--powder", arguments->powder,
                   "powder file, or scene with the powder, in place of the experiment's powder; refused by "
                   "experiments with powders of their own")
      ->check(CLI::ExistingFile);
  if (one.name == kWithFilms)
    command->add_flag("--film", arguments->film, "make films of the runs, which keep their grains");
  command->footer("Example:\n  diefill lab " + one.name + " --seeds 3 --budget 20");
  command->callback(
      [arguments, &one, &chosen] { chosen = [arguments, &one] { return experiment(one, *arguments); }; });
}

void add_powder_sheet(CLI::App& lab, Action& chosen) {
  auto* sheet = lab.add_subcommand("powder", "Data sheet of a powder: density, flow, angles, discharge");
  auto of_sheet = std::make_shared<LabArguments>();
  add_options(*sheet, *of_sheet);
  sheet->add_option("FILE", of_sheet->powder, "powder file, as diefill calibrate writes it")
      ->required()
      ->check(CLI::ExistingFile);
  sheet->footer("Example:\n  diefill lab powder my_powder.toml --out out/lab");
  sheet->callback([of_sheet, &chosen] { chosen = [of_sheet] { return powder_sheet(*of_sheet); }; });
}

void add_fidelity(CLI::App& lab, Action& chosen) {
  auto* page = lab.add_subcommand("fidelity", "Run all experiments with scenes and write FIDELITY.md");
  auto arguments = std::make_shared<LabArguments>();
  add_options(*page, *arguments);
  page->get_option("--quiet")->description("print no progress and no tables: they are in the page");
  page->add_option("--page", arguments->page,
                   "file to write (default: process/laboratory/FIDELITY.md of a source tree that may be "
                   "written, else FIDELITY.md in the folder of --out); rewritten beside it, with the values "
                   "of all calls: kept_results.csv, other_figures.csv and OTHER_FIGURES.md");
  page->footer("Example:\n  diefill lab fidelity --collect --page out/FIDELITY.md");
  page->callback([arguments, &chosen] {
    arguments->prints_tables = !arguments->quiet;
    chosen = [arguments] { return fidelity(*arguments); };
  });
}

}  // namespace

PublishedFigures published_figures_in(const std::string& scenes, const std::vector<std::string>& ids) {
  const fs::path file = scenes_folder(scenes) / laboratory::kPublishedFigures;
  PublishedFigures figures = laboratory::read_published_figures(file);
  laboratory::require_figures(figures, ids, file);
  return figures;
}

void write_figures(const std::filesystem::path& directory, const results::ExperimentResult& result,
                   const PublishedFigures& published) {
  if (result.figures.empty()) return;
  const auto table = laboratory::table_of_figures(result, published);
  results::write_lab_table(directory, table);
  std::printf("%s", lab_table_text(table).c_str());
}

std::string list_of_experiments(const std::string& scenes) {
  const auto figures = published_figures_in(scenes);
  std::string text;
  for (const auto& one : laboratory::scene_experiments()) {
    int count = 0;
    for (const auto& figure : figures) count += figure.experiment == one.name ? 1 : 0;
    char line[200];
    std::snprintf(line, sizeof line, "%-18s %2d published figure%s %s\n", one.name.c_str(), count,
                  count == 1 ? ": " : "s:", one.question.c_str());
    text += line;
  }
  return text;
}

void add_lab_experiments(CLI::App& lab, Action& chosen) {
  for (const auto& one : laboratory::scene_experiments()) add_experiment(lab, one, chosen);
  add_powder_sheet(lab, chosen);
  add_fidelity(lab, chosen);
}

}  // namespace diefill::app
