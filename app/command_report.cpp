#include <algorithm>
#include <cstdio>

#include "app/commands.h"
#include "app/drawing.h"
#include "app/exit_code.h"
#include "app/output.h"
#include "process/results/atomic_file.h"
#include "process/results/result_file.h"
#include "process/scene/scene_error.h"
#include "render/report/html.h"
#include "render/report/pdf.h"
#include "render/report/report.h"

namespace diefill::app {

namespace {

namespace fs = std::filesystem;

struct ReportArguments {
  std::vector<std::string> directories;
  std::string out;
  bool pdf = false;
};

/// Results directories below `directory`, in order of their names; where numbers end the names, in their
/// order.
std::vector<fs::path> runs_below(const fs::path& directory) {
  std::vector<fs::path> found;
  for (const auto& entry : fs::recursive_directory_iterator(directory))
    if (entry.path().filename() == "results.h5") found.push_back(entry.path().parent_path());
  std::sort(found.begin(), found.end(), [](const fs::path& a, const fs::path& b) {
    if (a.parent_path() != b.parent_path()) return a.parent_path() < b.parent_path();
    const auto length = [](const fs::path& path) { return path.filename().string().size(); };
    return length(a) != length(b) ? length(a) < length(b) : a < b;  // seed-9 before seed-10
  });
  return found;
}

/// A comparison's directory holds runs in its subdirectories; any other directory is a run itself.
void add_runs(std::vector<render::report::Run>& runs, const fs::path& directory) {
  if (!fs::exists(directory / "results.h5") && fs::exists(directory / "comparison.json")) {
    const auto below = runs_below(directory);
    if (below.empty())
      throw process::SceneError(directory.string() + ": a comparison without any results; finish it first");
    for (const auto& run : below)
      runs.push_back({fs::relative(run, directory).string(), results::read_results(run)});
    return;
  }
  runs.push_back({directory.string(), results::read_results(directory)});
}

int report(const ReportArguments& arguments) {
  std::vector<render::report::Run> runs;
  for (const auto& directory : arguments.directories) add_runs(runs, directory);
  const fs::path html = arguments.out.empty() ? fs::path(arguments.directories.front()) / "report.html"
                                              : fs::path(arguments.out);
  if (html.extension() == ".pdf")
    throw process::SceneError(
        "--out: found \"" + arguments.out +
        "\"; it names the HTML page, such as \"report.html\"; --pdf writes the PDF beside it");
  make_output_directory(html.parent_path().empty() ? fs::path(".") : html.parent_path());
  write_output([&] {
    set_up_drawing();
    const auto document = render::report::report_of(runs);
    results::write_text_atomically(html, render::report::html_page(document));
    std::printf("%s\n", html.string().c_str());
    if (!arguments.pdf) return;
    const fs::path pdf = fs::path(html).replace_extension(".pdf");
    results::write_text_atomically(pdf, render::report::pdf_pages(document));
    std::printf("%s\n", pdf.string().c_str());
  });
  return kDone;
}

}  // namespace

void add_report(CLI::App& program, Action& chosen) {
  auto* command = program.add_subcommand(
      "report", "Write one page about a run, or about several held against each other, to show and to print");
  auto arguments = std::make_shared<ReportArguments>();
  command
      ->add_option(
          "DIR", arguments->directories,
          "results directories of runs, or of a comparison; the first is what others are held against")
      ->required();
  command->add_flag("--pdf", arguments->pdf, "also a PDF, beside the HTML page");
  command->add_option("--out", arguments->out,
                      "file of the HTML page (default: report.html in the first DIR)");
  command->footer(
      "Runs whose scenes differ in nothing but the seed count as one strategy, and their scatter is given.\n"
      "Examples:\n"
      "  diefill report out/narrow_ring --pdf\n"
      "  diefill report out/slow out/fast out/fast_seed_2 --out out/strategies.html");
  command->callback([arguments, &chosen] { chosen = [arguments] { return report(*arguments); }; });
}

}  // namespace diefill::app
