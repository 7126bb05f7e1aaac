// What ranks, mpirun and ssh say on one stream: ranks' lines are shown, the others become one.
#include "process/cluster/mpirun_output.h"

#include <gtest/gtest.h>

#include <sstream>

namespace diefill::process::cluster {
namespace {

constexpr const char* kRuler = "--------------------------------------------------------------------------\n";

/// What is shown of `text`.
std::string shown(MpirunOutput& talk, const std::string& text) {
  std::istringstream lines(text);
  std::string line, all;
  while (std::getline(lines, line))
    if (talk.is_of_program(line)) all += line + '\n';
  return all;
}

TEST(MpirunOutput, OfARunIsWhatTheRanksSay) {
  MpirunOutput talk;
  EXPECT_EQ(shown(talk, "diefill-mpi: ranks begin\n 10 %  t = 0.1 s\ndiefill: out of range\n"),
            " 10 %  t = 0.1 s\ndiefill: out of range\n");
  EXPECT_TRUE(talk.begun());
  EXPECT_TRUE(talk.reported_error());
}

TEST(MpirunOutput, OfAKilledRankNamesIt) {
  MpirunOutput talk;
  const std::string ends =
      std::string(kRuler) +
      "Primary job  terminated normally, but 1 process returned\na non-zero exit code.\n" + kRuler + kRuler +
      "mpirun noticed that process rank 1 with PID 0 on node a exited on signal 9 "
      "(Killed).\n" +
      kRuler;
  EXPECT_EQ(shown(talk, "diefill-mpi: ranks begin\n 10 %\n" + ends), " 10 %\n");
  EXPECT_FALSE(talk.reported_error());
  EXPECT_EQ(talk.reason(),
            "mpirun noticed that process rank 1 with PID 0 on node a exited on signal 9 (Killed)");
}

TEST(MpirunOutput, OfAHostThatCannotBeReachedIsTheWordOfSsh) {
  MpirunOutput talk;
  EXPECT_EQ(shown(talk, "ssh: connect to host b port 22: Connection refused\n" + std::string(kRuler) +
                            "ORTE was unable to reliably start one or more daemons.\nThis usually is caused "
                            "by:\n\n* not finding\n" +
                            kRuler),
            "");
  EXPECT_FALSE(talk.begun());
  EXPECT_EQ(talk.reason(), "ssh: connect to host b port 22: Connection refused");
}

TEST(MpirunOutput, OfTooFewSlotsIsItsFirstParagraph) {
  MpirunOutput talk;
  EXPECT_EQ(shown(talk, std::string(kRuler) +
                            "There are not enough slots available in the system to satisfy the 8\nslots that "
                            "were requested by the application:\n\n  true\n" +
                            kRuler),
            "");
  EXPECT_EQ(
      talk.reason(),
      "There are not enough slots available in the system to satisfy the 8 slots that were requested by "
      "the application");
}

}  // namespace
}  // namespace diefill::process::cluster
