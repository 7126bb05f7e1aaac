// Folders of jobs: what stands stays, what no longer fits is renamed, and all that a scene needs is there.
#include <gtest/gtest.h>

#include <atomic>
#include <map>

#include "process/compare/backups.h"
#include "process/compare/job_folder.h"
#include "process/compare/run_jobs.h"
#include "process/results/storage/result_file.h"
#include "process/run/fill_run.h"
#include "tests/process/wrong_scene.h"
#include "tests/support/temporary_folder.h"

namespace diefill::process {
namespace {

namespace fs = std::filesystem;
using support::contents;

const std::string kVariants =
    "\n[[variant]]\nname = \"quick\"\n[[variant]]\nname = \"beginnings\"\n"
    "powder.friction = 0.5\n";

/// A scene with its files, and a directory of jobs.
class Jobs {
 public:
  Jobs() {
    folder_.write("die.stl", "die");
    folder_.write("shoe.stl", "shoe");
  }

  const fs::path& folder() const { return folder_.path(); }
  fs::path out() const { return folder() / "out"; }
  void write(const std::string& name, const std::string& bytes) const { folder_.write(name, bytes); }

  /// Writes the jobs of `text`; what is said meanwhile is in `said`.
  results::JobList write_jobs_of(const std::string& text, int seeds = 1) {
    said.clear();
    const auto variants = read_variants(folder_.write("scene.toml", text));
    return write_jobs(out(), {"title", variants, seeds, {}},
                      [this](const std::string& line) { said += line + '\n'; });
  }

  /// As if every job had been run.
  void finish(const results::JobList& list) const {
    for (const auto& job : list.jobs)
      for (const char* name : {"report.json", "results.h5", "run.log"})
        std::ofstream(out() / job.folder / name) << job.folder;
  }

  std::string said;

 private:
  support::TemporaryFolder folder_;
};

std::size_t finished(const Jobs& jobs, const results::JobList& list) {
  std::size_t count = 0;
  for (const auto& job : list.jobs)
    count += state_of(jobs.out(), job).stage == JobState::Stage::finished ? 1 : 0;
  return count;
}

TEST(JobFolders, KeepResultsWhateverHasNoPartInTheComputation) {
  Jobs jobs;
  const std::string scene = faultless_scene() + kVariants;
  jobs.finish(jobs.write_jobs_of(scene, 2));
  fs::copy(jobs.folder() / "die.stl", jobs.folder() / "renamed.stl");
  for (const auto& [old, other] : {std::pair{"Narrow ring, one passage", "Another title"},
                                   {"max_time = \"5 s\"", "max_time = \"50 s\"   # longer"},
                                   {"max_time = \"5 s\"", "checkpoint_interval = \"7 s\""},
                                   {"file = \"die.stl\"", "file  =  \"renamed.stl\""}}) {
    const auto list = jobs.write_jobs_of(support::exchanged(scene, old, other), 2);
    EXPECT_EQ(finished(jobs, list), 4U) << other;
    EXPECT_EQ(jobs.said, "") << other;
  }
}

TEST(JobFolders, OfARunAreNamedByItsVariantAndSeed) {
  Variant variant{"quick", "quick-one", {}};
  variant.scene.seed = 7;
  const results::Job job = job_of(variant, 2);
  EXPECT_EQ(job.variant, "quick");
  EXPECT_EQ(job.seed, 9U);
  EXPECT_EQ(job.folder, "quick-one/seed-9");
  EXPECT_EQ(job.folder, results::job_folder("quick-one", 9));
}

TEST(JobFolders, AreOnlyReadWhereJobsAreFound) {
  Jobs jobs;
  const std::string scene = faultless_scene() + kVariants;
  const auto before = jobs.write_jobs_of(scene);
  jobs.finish(before);
  const auto all = [&] {
    std::map<fs::path, std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(jobs.out()))
      files[entry.path()] = entry.is_regular_file() ? contents(entry.path()) : "";
    return files;
  };
  const auto files = all();
  const auto find = [&](const std::string& text) {
    std::ofstream(jobs.folder() / "scene.toml") << text;
    return find_jobs(jobs.out(), {"title", read_variants(jobs.folder() / "scene.toml"), 2, {}});
  };
  const FoundJobs same = find(scene);
  EXPECT_EQ(same.list.jobs.size(), 4U);
  EXPECT_EQ(same.list.jobs[1].folder, before.jobs[1].folder);
  EXPECT_TRUE(same.other_scenes.empty());
  const FoundJobs other = find(support::exchanged(scene, "powder.friction = 0.5", "powder.friction = 0.6"));
  EXPECT_EQ(other.other_scenes, std::set<std::string>{before.jobs[1].folder});
  EXPECT_EQ(all(), files);
}

TEST(JobFolders, KeepAsideWhatNoLongerFits) {
  Jobs jobs;
  const std::string scene = faultless_scene() + kVariants;
  const auto before = jobs.write_jobs_of(scene);
  jobs.finish(before);
  const std::string changed = support::exchanged(scene, "powder.friction = 0.5", "powder.friction = 0.6");
  const auto list = jobs.write_jobs_of(changed);
  EXPECT_EQ(finished(jobs, list), 1U);
  const std::string folder = before.jobs[1].folder;
  EXPECT_EQ(contents(jobs.out() / (folder + "-previous-1") / "results.h5"), folder);
  EXPECT_TRUE(fs::exists(jobs.out() / (folder + "-previous-1") / "scene.toml"));
  EXPECT_NE(jobs.said.find(folder + " as seed-1-previous-1"), std::string::npos) << jobs.said;
  // A scene that a user has changed by hand is kept as well.
  std::ofstream(jobs.out() / folder / "scene.toml", std::ios::app) << "[economy]\nsleep = true\n";
  jobs.write_jobs_of(changed);
  EXPECT_TRUE(fs::exists(jobs.out() / (folder + "-previous-2") / "scene.toml"));
  // Other contents of a CAD file are another part.
  jobs.finish(list);
  jobs.write("shoe.stl", "another shoe");
  EXPECT_EQ(finished(jobs, jobs.write_jobs_of(changed)), 0U);
  EXPECT_TRUE(fs::exists(jobs.out() / "quick/seed-1-previous-1/results.h5"));
}

TEST(JobFolders, SayWhichResultsAreInTheListNoMore) {
  Jobs jobs;
  jobs.finish(jobs.write_jobs_of(faultless_scene() + kVariants, 3));
  const auto list = jobs.write_jobs_of(faultless_scene() + "\n[[variant]]\nname = \"quick\"\n", 2);
  EXPECT_EQ(list.jobs.size(), 2U);
  EXPECT_NE(jobs.said.find("no longer in the list and were left in place: "), std::string::npos) << jobs.said;
  EXPECT_NE(jobs.said.find("quick/seed-3"), std::string::npos) << jobs.said;
  EXPECT_EQ(contents(jobs.out() / "quick/seed-3/results.h5"), "quick/seed-3");
}

TEST(JobFolders, KeepAListThatCannotBeRead) {
  Jobs jobs;
  jobs.write_jobs_of(faultless_scene());
  for (const std::string damaged :
       {"{", "{\"title\": \"\", \"variants\": [], \"jobs\": []}",
        "{\"title\": \"\", \"variants\": [\"a\"], \"jobs\": [{\"variant\": \"a\", "
        "\"seed\": 1, \"folder\": \"../elsewhere\"}]}"}) {
    jobs.write("out/jobs.json", damaged);
    EXPECT_THROW(results::read_job_list(jobs.out()), results::ResultError) << damaged;
  }
  jobs.write_jobs_of(faultless_scene());
  EXPECT_NE(jobs.said.find("it was renamed to jobs.json-previous-1"), std::string::npos) << jobs.said;
  EXPECT_EQ(results::read_job_list(jobs.out()).jobs.size(), 1U);
}

TEST(JobFolders, TakeAlongAllThatAScenesFilesReferTo) {
  Jobs jobs;
  const std::string gltf = R"({"asset": {"version": "2.0"}, "buffers": [{"uri": "parts/a%20b.bin"}]})";
  fs::create_directory(jobs.folder() / "parts");
  jobs.write("parts/a b.bin", "buffer");
  jobs.write("shoe.gltf", gltf);
  jobs.write("motion.csv", "time s,x mm\n0,0\n1,1\n");
  const std::string scene = support::exchanged(
      support::exchanged(faultless_scene(), "file = \"shoe.stl\"\nlength_unit = \"mm\"",
                         "file = \"shoe.gltf\""),
      "[numerics]", "[[step]]\nkind = \"table\"\ntool = \"shoe\"\nfile = \"motion.csv\"\n[numerics]");
  const auto list = jobs.write_jobs_of(scene);
  jobs.finish(list);
  const Scene alone = read_scene(jobs.out() / list.jobs[0].folder / "scene.toml");
  EXPECT_EQ(alone.steps.size(), 2U) << "the table of the motion is beside it";
  EXPECT_EQ(contents(alone.tools[1].file), gltf);
  EXPECT_EQ(contents(alone.tools[1].file.parent_path() / "parts/a b.bin"), "buffer");
  EXPECT_EQ(finished(jobs, jobs.write_jobs_of(scene)), 1U);
  jobs.write("parts/a b.bin", "other!");
  EXPECT_EQ(finished(jobs, jobs.write_jobs_of(scene)), 0U) << "another buffer is another part";
  jobs.finish(list);
  jobs.write("motion.csv", "time s,x mm\n0,0\n1,2\n");
  EXPECT_EQ(finished(jobs, jobs.write_jobs_of(scene)), 0U) << "another motion is another computation";
}

TEST(JobFolders, RefuseSeedsBeyondTheLargest) {
  Jobs jobs;
  const std::string scene = support::exchanged(faultless_scene(), "seed = 1", "seed = 9223372036854775806");
  EXPECT_EQ(jobs.write_jobs_of(scene, 2).jobs[1].seed, 9223372036854775807U);
  try {
    jobs.write_jobs_of(scene, 3);
    ADD_FAILURE() << "no complaint";
  } catch (const SceneError& error) {
    EXPECT_NE(std::string(error.what()).find("found 9223372036854775806"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("give one from 0 to 9223372036854775805"), std::string::npos)
        << error.what();
  }
}

TEST(RunJobs, AStopSaysHowTheCallerWantsItContinued) {
  const support::TemporaryFolder folder;
  const std::atomic<bool> stop = true;
  JobOptions options;
  options.stop = &stop;
  options.show_progress = false;
  options.to_continue = "add --resume to continue";
  try {
    run_jobs(folder.path(), {"title", {"a"}, {{"a", 1, "a/seed-1"}}}, options);
    ADD_FAILURE() << "not stopped";
  } catch (const Interrupted& error) {
    EXPECT_NE(std::string(error.what()).find("1 runs were not started"), std::string::npos) << error.what();
    EXPECT_TRUE(std::string(error.what()).ends_with("; add --resume to continue")) << error.what();
  }
}

results::Comparison comparison_of(const std::vector<std::string>& folders) {
  results::Comparison comparison;
  comparison.variants = {"a"};
  for (const std::string& folder : folders) {
    results::ComparedRun run;
    run.folder = folder;
    run.state = "finished";
    run.state_hash = "hash of " + folder;
    comparison.runs.push_back(run);
  }
  return comparison;
}

TEST(EarlierTables, AreKeptWhereTheyTellMore) {
  const support::TemporaryFolder folder;
  const auto& directory = folder.path();
  EXPECT_EQ(back_up_earlier_tables(directory, comparison_of({"a"})), std::nullopt);
  results::write_comparison(directory, comparison_of({"a", "b"}));
  EXPECT_EQ(back_up_earlier_tables(directory, comparison_of({"a", "b", "c"})), std::nullopt);
  const std::string before = contents(directory / "comparison.json");
  EXPECT_EQ(back_up_earlier_tables(directory, comparison_of({"a", "c"})), directory / "previous-1");
  EXPECT_EQ(contents(directory / "previous-1/comparison.json"), before);
  EXPECT_TRUE(fs::exists(directory / "previous-1/comparison.csv"));
  EXPECT_FALSE(fs::exists(directory / "comparison.csv"));
  folder.write("comparison.json", "{");
  EXPECT_EQ(back_up_earlier_tables(directory, comparison_of({"a"})), directory / "previous-2");
  folder.write("tradeoff.json", R"({"settings": [{"setting": "base", "seeds": 2}]})");
  results::Tradeoff tradeoff;
  tradeoff.points.resize(1);
  tradeoff.points[0].name = "base";
  tradeoff.points[0].seeds = 2;
  EXPECT_EQ(back_up_earlier_tables(directory, tradeoff), std::nullopt);
  tradeoff.points[0].seeds = 1;
  EXPECT_EQ(back_up_earlier_tables(directory, tradeoff), directory / "previous-3");
}

TEST(EarlierTables, AForeignFileOfAComparisonsNameIsMoved) {
  const support::TemporaryFolder folder;
  const auto& directory = folder.path();
  folder.write("comparison.csv", "mine");
  folder.write("comparison.toml", "a scene");
  EXPECT_EQ(back_up_earlier_tables(directory, comparison_of({"a"})), directory / "previous-1");
  EXPECT_EQ(contents(directory / "previous-1/comparison.csv"), "mine");
  EXPECT_TRUE(fs::exists(directory / "comparison.toml"));
}

TEST(EarlierTables, AreMovedWithChartsAndPagesButNotTheListOfJobs) {
  const support::TemporaryFolder folder;
  const auto& directory = folder.path();
  folder.write("jobs.json", "{}");
  EXPECT_EQ(back_up_tables(directory), std::nullopt);
  for (const char* name : {"sheet.json", "sheet.csv", "chart.png", "page.html", "page.pdf"})
    folder.write(name, name);
  EXPECT_EQ(back_up_tables(directory), directory / "previous-1");
  for (const char* name : {"sheet.json", "sheet.csv", "chart.png", "page.html", "page.pdf"}) {
    EXPECT_FALSE(fs::exists(directory / name)) << name;
    EXPECT_EQ(contents(directory / "previous-1" / name), name);
  }
  EXPECT_TRUE(fs::exists(directory / "jobs.json"));
}

results::Calibration calibration_of(const std::vector<double>& frictions, bool fitted) {
  results::Calibration calibration;
  for (const double friction : frictions)
    calibration.points.push_back({"start", {friction}, "finished", "", 1, 1});
  calibration.fitted = fitted;
  if (fitted) calibration.samples = {{0.5}};
  return calibration;
}

TEST(EarlierTables, OfACalibrationAreReplacedByOneWithAllOfIts) {
  const support::TemporaryFolder folder;
  const auto& directory = folder.path();
  EXPECT_EQ(back_up_earlier_tables(directory, calibration_of({0.2}, true)), std::nullopt);
  results::Calibration earlier = calibration_of({0.2, 0.4}, true);
  earlier.points.push_back({"best", {0.31}, "finished", "", 1, 1});
  earlier.points.push_back({"search", {0.5}, "failed", "too soft", 1, 1});
  results::write_calibration(directory, earlier);
  EXPECT_EQ(back_up_earlier_tables(directory, calibration_of({0.2, 0.4, 0.6}, true)), std::nullopt);
  EXPECT_EQ(back_up_earlier_tables(directory, calibration_of({0.2, 0.6}, true)), directory / "previous-1");
  EXPECT_TRUE(fs::exists(directory / "previous-1/calibration_points.csv"));
  EXPECT_FALSE(fs::exists(directory / "calibration.csv"));
}

TEST(EarlierTables, OfACalibrationWithAFitAreKeptWhereTheNewOneHasNone) {
  const support::TemporaryFolder folder;
  const auto& directory = folder.path();
  results::write_calibration(directory, calibration_of({0.2, 0.4}, true));
  EXPECT_EQ(back_up_earlier_tables(directory, calibration_of({0.2, 0.4}, false)), directory / "previous-1");
  results::write_calibration(directory, calibration_of({0.2, 0.4}, false));
  EXPECT_EQ(back_up_earlier_tables(directory, calibration_of({0.2, 0.4}, false)), std::nullopt);
}

TEST(EarlierTables, ThePowderOfAnEarlierFitIsMovedWhereTheNewOneHasNone) {
  const support::TemporaryFolder folder;
  const auto& directory = folder.path();
  results::write_calibration(directory, calibration_of({0.2, 0.4}, true));
  folder.write("powder.toml", "earlier\n");
  EXPECT_EQ(back_up_earlier_tables(directory, calibration_of({0.2, 0.4}, true)), std::nullopt);
  EXPECT_EQ(back_up_earlier_tables(directory, calibration_of({0.2, 0.4}, false)), directory / "previous-1");
  EXPECT_EQ(contents(directory / "previous-1/powder.toml"), "earlier\n");
  EXPECT_FALSE(fs::exists(directory / "powder.toml"));
  results::write_calibration(directory, calibration_of({0.2, 0.4}, false));
  folder.write("powder.toml", "left there\n");
  EXPECT_EQ(back_up_earlier_tables(directory, calibration_of({0.2, 0.4}, false)), directory / "previous-2");
  EXPECT_FALSE(fs::exists(directory / "powder.toml"));
  EXPECT_TRUE(fs::exists(directory / "calibration.json"));
}

TEST(EarlierTables, APowderBesideAScreeningStays) {
  const support::TemporaryFolder folder;
  folder.write("powder.toml", "mine\n");
  results::Calibration screening = calibration_of({0.2}, false);
  screening.screening.quantities.emplace_back();
  EXPECT_EQ(back_up_earlier_tables(folder.path(), screening), std::nullopt);
  EXPECT_EQ(contents(folder.path() / "powder.toml"), "mine\n");
}

TEST(EarlierTables, AForeignFileOfACalibrationsNameIsMovedAndTheCalibrationFileIsNot) {
  const support::TemporaryFolder folder;
  folder.write("calibration.csv", "mine\n");
  folder.write("calibration.toml", "seed = 1\n");
  EXPECT_EQ(back_up_earlier_tables(folder.path(), calibration_of({0.2}, true)), folder.path() / "previous-1");
  EXPECT_EQ(contents(folder.path() / "previous-1/calibration.csv"), "mine\n");
  EXPECT_TRUE(fs::exists(folder.path() / "calibration.toml"));
}

}  // namespace
}  // namespace diefill::process
