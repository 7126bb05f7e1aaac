#include <cstdio>
#include <fstream>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/commands/commands.h"
#include "app/commands/shared_options/renderer_choice.h"
#include "app/exit_code.h"
#include "app/options/output_file.h"
#include "app/options/results_directories.h"
#include "app/output.h"
#include "app/pictures/drawing.h"
#include "app/pictures/film_file.h"
#include "app/pictures/view_extras.h"
#include "process/input/scene_error.h"
#include "process/measured_data/compare_with_measured.h"
#include "process/results/storage/atomic_file.h"
#include "process/results/storage/file_contents.h"
#include "process/results/storage/result_file.h"
#include "process/tooling/progress.h"
#include "render/report/html.h"
#include "render/report/pdf.h"
#include "render/report/report.h"

namespace diefill::app {

namespace {

namespace fs = std::filesystem;

struct ReportArguments {
  std::vector<std::string> directories, measured;
  std::string out;
  bool pdf = false;
};

constexpr const char* kComparison = "comparison.json";

/// Folders and variants of the runs that `directory`/comparison.json lists. Throws process::SceneError for
/// any other file of that name.
std::vector<std::pair<std::string, std::string>> runs_listed_in(const fs::path& directory) {
  const fs::path file = directory / kComparison;
  std::vector<std::pair<std::string, std::string>> runs;
  try {
    std::ifstream stream(file);
    const auto comparison = nlohmann::json::parse(stream);
    for (const auto& run : comparison.at("runs"))
      runs.emplace_back(run.at("folder").get<std::string>(), run.at("variant").get<std::string>());
  } catch (const std::exception&) {  // also std::ios_base::failure, of a directory of that name
    throw process::SceneError(file.string() +
                              ": not a comparison written by diefill; give another directory, or run the "
                              "comparison again");
  }
  return runs;
}

/// A run of the report and where its results are.
struct FoundRun {
  render::report::Run run;
  fs::path directory;
};

/// The finished runs that `directory`/comparison.json lists, by variant and seed.
void add_comparison(std::vector<FoundRun>& runs, const fs::path& directory) {
  std::size_t missing = 0;
  const auto listed = runs_listed_in(directory);
  for (const auto& [folder, variant] : listed) {
    if (fs::exists(directory / folder / "results.h5"))
      runs.push_back({{folder, results::read_results(directory / folder), variant}, directory / folder});
    else
      ++missing;
  }
  if (missing == listed.size())
    throw process::SceneError((directory / kComparison).string() +
                              ": the comparison has no results; finish it first");
  if (missing > 0)
    std::fprintf(stderr, "note: %zu runs of %s have no results and are omitted\n", missing,
                 directory.string().c_str());
}

/// A comparison's directory holds runs in its subdirectories; any other directory is a run itself.
void add_runs(std::vector<FoundRun>& runs, const fs::path& directory) {
  if (!fs::exists(directory / "results.h5") && fs::exists(directory / kComparison))
    add_comparison(runs, directory);
  else
    runs.push_back({{directory.string(), results::read_results(directory), ""}, directory});
}

/// The runs in the directories. Throws process::SceneError for one that would count as two seeds of a
/// variant.
std::vector<render::report::Run> runs_in(const std::vector<std::string>& directories) {
  std::vector<FoundRun> found;
  for (const auto& directory : directories) add_runs(found, directory);
  std::map<std::string, std::vector<fs::path>> places;
  std::map<std::string, std::vector<ReadDirectory>> results;
  for (const auto& one : found) {
    places[one.run.strategy].push_back(one.directory);
    results[one.run.strategy].push_back({one.directory, &one.run.result});
  }
  for (const auto& [strategy, of_strategy] : places) require_distinct("DIR", of_strategy);
  for (const auto& [strategy, of_strategy] : results) require_no_copies("DIR", of_strategy);
  std::vector<render::report::Run> runs;
  for (auto& one : found) runs.push_back(std::move(one.run));
  return runs;
}

/// The page, and the PDF beside it where that is wanted. Throws process::SceneError where one of them is no
/// such file, or one that the report is made of.
std::vector<OutputFile> files_of(const ReportArguments& arguments) {
  const fs::path html = arguments.out.empty() ? fs::path(arguments.directories.front()) / "report.html"
                                              : fs::path(arguments.out);
  std::vector<OutputFile> files = {{"--out", html, {".html", ".htm"}}};
  if (ending_of(html) == ".pdf")
    throw process::SceneError(
        "--out: found \"" + arguments.out +
        "\", expected the HTML page, such as \"report.html\"; --pdf writes the PDF next to it");
  if (arguments.pdf) files.push_back({"--pdf", fs::path(html).replace_extension(".pdf"), {".pdf"}});
  std::vector<fs::path> inputs(arguments.measured.begin(), arguments.measured.end());
  for (const auto& directory : arguments.directories)
    for (const char* name : {"results.h5", kComparison}) inputs.push_back(fs::path(directory) / name);
  for (const auto& file : files) require_output_file(file, inputs);
  return files;
}

/// The films of a run that are small enough for a page.
std::vector<render::report::Film> films_in(const fs::path& directory) {
  constexpr std::uintmax_t kLargest = 8'000'000;  // bytes
  std::vector<render::report::Film> films;
  for (const auto& [file, caption] :
       {std::pair{kFilmFile, "Filling over time."}, {kTurntableFile, "The final state from all sides."}}) {
    const fs::path path = directory / file;
    if (!fs::exists(path) || fs::file_size(path) > kLargest) continue;
    films.push_back({QByteArray::fromStdString(results::contents_or_nothing(path).value_or("")), caption});
  }
  return films;
}

/// Measures what the views of the runs show, one run after the other, with progress over all of them.
class ExtrasWithProgress {
 public:
  explicit ExtrasWithProgress(std::size_t runs) : runs_(static_cast<double>(runs)) {}

  render::report::ViewExtras operator()(const results::FillResult& result) {
    const double before = done_++;
    const auto on_progress = progress_->callback();
    return view_extras(result, [&](double share, const std::string& doing) {
      on_progress((before + share) / runs_, doing);
    });
  }

 private:
  std::shared_ptr<process::Progress> progress_ = std::make_shared<process::Progress>(true);
  double runs_, done_ = 0;
};

int report(const ReportArguments& arguments) {
  const auto measured = process::read_measured_files(arguments.measured);
  require_distinct("DIR", {arguments.directories.begin(), arguments.directories.end()});
  auto runs = runs_in(arguments.directories);
  const auto files = files_of(arguments);
  for (auto& run : runs) run.other_cavities = of_other_cavities(run.result);
  for (auto& run : runs) run.films = films_in(run.name);
  for (auto& run : runs)
    for (const auto& file : measured)
      run.measured.push_back(process::compare_with_measured(file, run.result));
  make_directory_of(files.front());
  write_output([&] {
    set_up_drawing();
    const auto document = render::report::report_of(runs, ExtrasWithProgress(runs.size()));
    for (const auto& output : files) {
      const bool page = output.option == "--out";
      results::write_text_atomically(
          output.file, page ? render::report::html_page(document) : render::report::pdf_pages(document));
      std::printf("%s\n", output.file.string().c_str());
    }
  });
  return kDone;
}

}  // namespace

void add_report(CLI::App& program, Action& chosen) {
  auto* command = program.add_subcommand(
      "report", "Write a report of a run, or a comparison of several runs, as one page");
  auto arguments = std::make_shared<ReportArguments>();
  command
      ->add_option("DIR", arguments->directories,
                   "results directories of runs, or of a comparison; the first is the reference")
      ->required();
  command
      ->add_option("--measured", arguments->measured,
                   "CSV of a measured profile or map to compare the results with")
      ->allow_extra_args(false);
  add_renderer(*command);
  command->add_flag("--pdf", arguments->pdf, "also write a PDF next to the HTML page");
  command->add_option("--out", arguments->out,
                      "file of the HTML page (default: report.html in the first DIR)");
  command->footer(
      "Runs whose scenes differ only in the seed count as one strategy; the report gives their scatter.\n"
      "Examples:\n"
      "  diefill report out/narrow_ring --pdf\n"
      "  diefill report out/narrow_ring --measured fill_level.csv --measured ct_density.csv\n"
      "  diefill report out/slow out/fast out/fast_seed_2 --out out/strategies.html");
  command->callback([arguments, &chosen] { chosen = [arguments] { return report(*arguments); }; });
}

}  // namespace diefill::app
