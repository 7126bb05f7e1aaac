// What the program writes for shells and for man is made from its own commands and options, and works.
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <memory>
#include <sstream>
#include <string>

#include "project_paths.h"
#include "tests/app/program.h"
#include "tests/support/temporary_folder.h"

namespace diefill::app {
namespace {

/// Standard output of a shell command.
std::string output_of(const std::string& command) {
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command.c_str(), "r"), pclose);
  std::string text;
  std::array<char, 4096> part{};
  while (const std::size_t count = std::fread(part.data(), 1, part.size(), pipe.get()))
    text.append(part.data(), count);
  return text;
}

/// What bash offers for the last of `words`, in a folder with two files; bars between several.
std::string completed(const std::string& words) {
  const support::TemporaryFolder folder;
  folder.write("a scene.toml", "");
  folder.write("complete.bash",
               run_program({"--completion", "bash"}).out + "COMP_WORDS=(diefill " + words +
                   ")\nCOMP_CWORD=$((${#COMP_WORDS[@]} - 1))\n_diefill\nIFS='|'\necho \"${COMPREPLY[*]}\"\n");
  return output_of("cd " + folder.path().string() + " && bash complete.bash");
}

TEST(Completion, BashCompletesCommandsOptionsChoicesAndFiles) {
  EXPECT_EQ(completed("comp"), "compare\n");
  EXPECT_EQ(completed("run --res"), "--resume\n");
  EXPECT_EQ(completed("new die --kind r"), "rectangular_die|ring\n");
  EXPECT_EQ(completed("lab sil"), "silo\n");
  EXPECT_EQ(completed("lab silo --si"), "--size\n");
  EXPECT_EQ(completed("lab silo --size m"), "medium\n");
  EXPECT_EQ(completed("map out --picture size"), "size-map|size-section\n");
  EXPECT_EQ(completed("fit-discharge masses.csv --law b"), "beverloo-round|beverloo-slit\n");
  for (const std::string command : {"run", "check", "estimate", "plan --variants", "compare"})
    EXPECT_EQ(completed(command + " scene.toml --setting ''"), "quick|working|reference\n") << command;
  EXPECT_EQ(completed("run comp"), "complete.bash\n");
  EXPECT_EQ(completed("run a"), "a scene.toml\n");
  EXPECT_EQ(completed("run x"), "\n");
}

TEST(Completion, ZshHasAFunctionForEveryCommand) {
  const Outcome outcome = run_program({"--completion", "zsh"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_TRUE(outcome.out.starts_with("#compdef diefill\n"));
  EXPECT_NE(outcome.out.find("_diefill_lab_silo() {"), std::string::npos);
  EXPECT_NE(outcome.out.find("--size[coarse\\: 4 times"), std::string::npos) << outcome.out;
}

TEST(Completion, OtherShellsAreRefused) {
  const Outcome outcome = run_program({"--completion", "fish"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(outcome.complaints(), 1U) << outcome.err;
}

TEST(ManualPage, ListsEveryCommandWithItsOptions) {
  const std::string page = run_program({"--man"}).out;
  EXPECT_TRUE(page.starts_with(".TH DIEFILL 1")) << page.substr(0, 200);
  for (const char* heading : {".SS \"diefill run SCENE [OPTIONS]\"", ".SS \"diefill lab silo [OPTIONS]\""})
    EXPECT_NE(page.find(heading), std::string::npos) << heading;
  EXPECT_NE(page.find("\\fB\\-\\-no\\-pictures\\fR"), std::string::npos);
}

TEST(ManualPage, TextsBelowTheOptionsFitALineOfATerminal) {
  std::istringstream page(run_program({"--man"}).out);
  bool as_written = false;
  constexpr std::size_t kLongest = 122;  // an example of one command line
  for (std::string line; std::getline(page, line);) {
    if (line == ".nf" || line == ".fi") as_written = line == ".nf";
    std::erase(line, '\\');
    if (!as_written) continue;
    EXPECT_LE(line.size(), kLongest) << line;
  }
}

TEST(ManualPage, ExplainsExitCodesAndTheEnvironment) {
  const std::string page = run_program({"--man"}).out;
  const std::size_t codes = page.find(".SH \"EXIT STATUS\"\n"), names = page.find(".SH ENVIRONMENT\n");
  ASSERT_NE(codes, std::string::npos);
  ASSERT_NE(names, std::string::npos);
  for (const char* code : {"0", "1", "2", "3", "4", "130"})
    EXPECT_LT(page.find(std::string(".B ") + code + "\n", codes), names) << code;
  EXPECT_NE(page.find(".B DIEFILL_PROGRESS_SECONDS\n", names), std::string::npos);
}

}  // namespace
}  // namespace diefill::app
