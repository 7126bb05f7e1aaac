#include <cstdio>

#include "app/backup_notes.h"
#include "app/commands/commands.h"
#include "app/commands/live_jobs.h"
#include "app/exit_code.h"
#include "app/options/numbers.h"
#include "app/options/output_file.h"
#include "app/output.h"
#include "app/pictures/drawing.h"
#include "app/stop_signals.h"
#include "app/tables/calibration_table.h"
#include "process/calibration/calibrate.h"
#include "process/calibration/check_cavities.h"
#include "process/calibration/input_files.h"
#include "process/calibration/screen.h"
#include "process/compare/backups.h"
#include "process/results/storage/atomic_file.h"
#include "render/report/calibration_report.h"
#include "render/report/html.h"
#include "render/report/pdf.h"

namespace diefill::app {

namespace {

namespace calibration = process::calibration;

struct CalibrateArguments {
  std::string file, out, export_to, collect_from;
  double budget = 0;
  int jobs = 1, threads = 1;
  bool resume = false, screen = false, pdf = false, quiet = false;
};

/// out/<folder of the file>_<name of the file>, with _screening after it for a screening.
std::filesystem::path directory_of(const CalibrateArguments& arguments) {
  for (const std::string& given : {arguments.export_to, arguments.collect_from, arguments.out})
    if (!given.empty()) return given;
  return default_directory(arguments.file, arguments.screen ? "_screening" : "");
}

std::string command_text(const CalibrateArguments& arguments) {
  std::string words = "diefill calibrate " + arguments.file;
  if (arguments.screen) words += " --screen";
  return words;
}

/// Existing runs are continued only with --resume; --collect needs existing runs.
void refuse_directory(const std::filesystem::path& directory, const CalibrateArguments& arguments) {
  const bool there = std::filesystem::exists(results::job_list_file(directory));
  if (!arguments.collect_from.empty() && !there)
    throw process::SceneError("--collect: found no runs in " + directory.string() +
                              "; give a directory that --export-jobs wrote");
  if (there && !arguments.resume && arguments.export_to.empty() && arguments.collect_from.empty())
    throw process::SceneError(
        directory.string() +
        ": holds runs of an earlier call; add --resume to continue, or choose another --out");
}

/// Refuses a directory where a table or powder.toml would take the place of a file that is read.
void refuse_to_replace_inputs(const CalibrateArguments& arguments, const std::filesystem::path& directory,
                              const calibration::CalibrationPlan& plan) {
  std::vector<std::string> names = results::calibration_tables();
  names.emplace_back("powder.toml");
  const char* option = !arguments.export_to.empty()      ? "--export-jobs"
                       : !arguments.collect_from.empty() ? "--collect"
                                                         : "--out";
  require_other_files(option, directory, names, calibration::input_files(plan));
}

void back_up_earlier_tables(const std::filesystem::path& directory, const results::Calibration& account) {
  if (const auto folder = process::back_up_earlier_tables(directory, account))
    print_note("note: earlier results with what this call does not have were moved to " + folder->string());
}

calibration::CalibrateOptions options_of(const CalibrateArguments& arguments,
                                         const std::filesystem::path& directory) {
  calibration::CalibrateOptions options;
  options.command = command_text(arguments);
  if (!arguments.export_to.empty()) options.open_runs = calibration::OpenRuns::write;
  if (!arguments.collect_from.empty()) options.open_runs = calibration::OpenRuns::leave_out;
  options.points.directory = directory;
  options.points.on_note = print_note;
  options.points.jobs.program = std::filesystem::read_symlink("/proc/self/exe");
  options.points.jobs.at_once = arguments.jobs;
  options.points.jobs.threads = arguments.threads;
  options.points.jobs.pictures = false;
  options.points.jobs.to_continue = "run the same command with --resume to continue";
  options.points.jobs.show_progress = !arguments.quiet;
  if (arguments.budget > 0) options.points.jobs.cpu_seconds = 60 * arguments.budget;
  if (!arguments.quiet) options.on_note = print_note;
  return options;
}

std::vector<std::string> write_all(const CalibrateArguments& arguments,
                                   const std::filesystem::path& directory,
                                   const results::Calibration& account) {
  const std::string name = arguments.screen ? "screening" : "calibration";
  std::vector<std::string> written = {"calibration.json", "calibration.csv", "calibration_points.csv",
                                      name + ".html"};
  write_output([&] {
    back_up_earlier_tables(directory, account);
    results::write_calibration(directory, account);
    set_up_drawing();
    const auto document = render::report::calibration_document(account);
    results::write_text_atomically(directory / (name + ".html"), render::report::html_page(document));
    if (arguments.screen) written.emplace_back("screening.csv");
    if (account.fitted) written.emplace_back("powder.toml");
    if (!arguments.pdf) return;
    results::write_text_atomically(directory / (name + ".pdf"), render::report::pdf_pages(document));
    written.push_back(name + ".pdf");
  });
  return written;
}

int print_exported(const std::filesystem::path& directory, const results::Calibration& account) {
  const std::string where = directory.string();
  if (account.open_runs == 0)
    std::printf("no runs are left to do (%s); diefill calibrate FILE --collect %s writes the powder\n",
                account.stopped.c_str(), where.c_str());
  else
    std::printf(
        "%zu runs in %s; copy it to where they should run and start them there:\n"
        "  sbatch slurm.sh                                 on a Slurm cluster\n"
        "  xargs -d '\\n' -n 1 -P 4 sh -c < jobs.txt        on one machine (or ./run_here.sh 4)\n"
        "then run diefill calibrate FILE --export-jobs %s for the next round, until no runs are left,\n"
        "and diefill calibrate FILE --collect %s\n",
        account.open_runs, where.c_str(), where.c_str(), where.c_str());
  return kDone;
}

int calibrate(const CalibrateArguments& arguments) {
  const auto plan = calibration::read_calibration(arguments.file);
  if (!arguments.screen) calibration::check_enough_data(plan);
  const std::filesystem::path directory = directory_of(arguments);
  refuse_directory(directory, arguments);
  refuse_to_replace_inputs(arguments, directory, plan);
  if (arguments.collect_from.empty()) {
    process::Progress progress(!arguments.quiet);
    calibration::check_cavities(plan, progress.callback());
  }
  const OutputDirectory output(directory, {"tools"}, arguments.export_to.empty() ? "--out" : "--export-jobs");
  auto options = options_of(arguments, directory);
  options.points.jobs.stop = &install_stop_handlers();
  options.points.jobs.watch =
      live_jobs(directory, (arguments.screen ? "Screening: " : "Calibration: ") + arguments.file);
  const auto account =
      arguments.screen ? calibration::screen(plan, options) : calibration::calibrate(plan, options);
  if (!arguments.export_to.empty()) return print_exported(directory, account);
  const auto written = write_all(arguments, directory, account);
  std::printf("%sin %s:", calibration_table(account).c_str(), directory.string().c_str());
  for (const auto& file : written) std::printf(" %s", file.c_str());
  std::printf("\n");
  return account.fitted || !account.screening.quantities.empty() ? kDone : kFailed;
}

void add_options(CLI::App& command, CalibrateArguments& arguments) {
  command.add_option("FILE", arguments.file, "calibration file (TOML): parameters with ranges, measurements")
      ->required();
  command.add_flag("--screen", arguments.screen,
                   "do not fit: run a two-level design over the ends of the ranges and chart the effects");
  command.add_option("--jobs", arguments.jobs, "runs at a time (default: 1)")->check(whole_number(1, 1024));
  command.add_option("--threads", arguments.threads, "threads of each run (default: 1)")
      ->check(whole_number(1, 1024));
  command
      .add_option(
          "--budget", arguments.budget,
          "total processor time of all runs in core minutes, including earlier calls (default: no limit)")
      ->check(number_above_zero());
  command.add_flag("--resume", arguments.resume,
                   "continue in a directory that holds runs; finished ones are kept");
  command.add_option("--out", arguments.out, "directory for results (default: out/<folder>_<file>)");
  command.add_flag("--pdf", arguments.pdf, "write the report as a PDF too");
  command.add_flag("--quiet", arguments.quiet, "print no progress");
  auto* exporting =
      command.add_option("--export-jobs", arguments.export_to,
                         "do not run: write the scenes and job scripts of the next round to this directory");
  auto* collecting = command
                         .add_option("--collect", arguments.collect_from,
                                     "do not run: find the powder from the finished runs of such a directory")
                         ->excludes(exporting);
  for (const char* other : {"--screen", "--out", "--budget"}) {
    exporting->excludes(other);
    collecting->excludes(other);
  }
  for (const char* other : {"--resume", "--jobs", "--threads"}) {
    exporting->excludes(other);
    collecting->excludes(other);
  }
  exporting->excludes("--pdf");
}

}  // namespace

void add_calibrate(CLI::App& program, Action& chosen) {
  auto* command = program.add_subcommand(
      "calibrate",
      "Find the powder that agrees with measurements, with error bars, and state what they cannot tell");
  auto arguments = std::make_shared<CalibrateArguments>();
  add_options(*command, *arguments);
  command->footer(
      "Examples:\n"
      "  diefill calibrate my_powder.toml --jobs 2 --budget 60\n"
      "  diefill calibrate my_powder.toml --resume                 go on after a stop or with more budget\n"
      "  diefill calibrate my_powder.toml --screen                 which parameters matter\n"
      "  diefill calibrate my_powder.toml --export-jobs jobs       the next round of runs, for a cluster\n"
      "  diefill calibrate my_powder.toml --collect jobs\n"
      "The file is explained in process/calibration/README.md. Writes powder.toml, which scenes use with\n"
      "powder.file = \"powder.toml\", calibration.html, calibration.json and CSV. Exit codes: 0 done, 1 too "
      "few runs\n"
      "gave values, 2 bad input, 130 stopped.");
  command->callback([arguments, &chosen] { chosen = [arguments] { return calibrate(*arguments); }; });
}

}  // namespace diefill::app
