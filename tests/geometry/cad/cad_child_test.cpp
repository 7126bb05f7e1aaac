// The child process that reads CAD: results come through whole, crashes and greed end as one reason.
#include "geometry/cad/cad_child.h"

#include <gtest/gtest.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <ctime>
#include <memory>
#include <stdexcept>

#include "tests/geometry/sample_meshes.h"

namespace diefill::geometry {
namespace {

ChildError error_of(const std::function<CadParts()>& read, const ChildLimits& limits = {1000, 60}) {
  try {
    read_in_child(read, limits);
  } catch (const ChildError& error) {
    return error;
  }
  throw std::logic_error("it was read");
}

bool has(const ChildError& error, const std::string& words) {
  return std::string(error.what()).find(words) != std::string::npos;
}

TEST(CadChild, HandsOnWhatWasRead) {
  CadParts contents;
  contents.metres_per_unit = 0.0254;
  contents.parts = {{"die", sample::tube(8, 12, 10, 1000)}, {"", sample::box({0, 0, 0}, {1, 2, 3})}};
  const CadParts read = read_in_child([&] { return contents; }, {1000, 60});
  ASSERT_EQ(read.parts.size(), 2U);
  EXPECT_EQ(read.metres_per_unit, contents.metres_per_unit);
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_EQ(read.parts[k].name, contents.parts[k].name);
    EXPECT_TRUE(read.parts[k].mesh.vertices == contents.parts[k].mesh.vertices);
    EXPECT_TRUE(read.parts[k].mesh.triangles == contents.parts[k].mesh.triangles);
  }
}

TEST(CadChild, PassesReasonsOn) {
  const ChildError error = error_of([]() -> CadParts { throw std::runtime_error("it contains no surface"); });
  EXPECT_EQ(error.failure, ChildFailure::kRefused);
  EXPECT_STREQ(error.what(), "it contains no surface");
}

// The kind of failure does not follow from the words, which may quote the file.
TEST(CadChild, ReasonsThatReadLikeOtherFailuresAreTheReaders) {
  for (const char* words : {"entity \"does not terminate\"", "more data than"}) {
    const ChildError error = error_of([&]() -> CadParts { throw std::runtime_error(words); });
    EXPECT_EQ(error.failure, ChildFailure::kRefused);
    EXPECT_STREQ(error.what(), words);
  }
}

TEST(CadChild, AReaderThatFailsWithoutWordsGetsSome) {
  EXPECT_TRUE(has(error_of([]() -> CadParts { throw std::runtime_error(""); }), "without a message"));
  EXPECT_TRUE(has(error_of([]() -> CadParts { throw 1; }), "without a message"));
}

TEST(CadChild, SurvivesACrash) {
  for (const int fatal : {SIGSEGV, SIGABRT, SIGFPE}) {
    const ChildError error = error_of([&]() -> CadParts {
      std::raise(fatal);
      return {};
    });
    EXPECT_EQ(error.failure, ChildFailure::kCrashed);
    EXPECT_TRUE(has(error, "importer crashed")) << error.what();
  }
}

// However the process that reads ends, such as by a kill, its reader ends too.
TEST(CadChild, EndsWithItsParent) {
  int ends[2];
  ASSERT_EQ(::pipe(ends), 0);
  const pid_t parent = ::fork();
  if (parent == 0) {
    ::close(ends[0]);
    error_of([&]() -> CadParts {
      [[maybe_unused]] const ssize_t begun = ::write(ends[1], "r", 1);
      ::sleep(60);
      return {};
    });
    ::_exit(0);
  }
  ::close(ends[1]);
  char byte = 0;
  ASSERT_EQ(::read(ends[0], &byte, 1), 1);
  ::kill(parent, SIGKILL);
  ::waitpid(parent, nullptr, 0);
  pollfd closed{ends[0], POLLIN, 0};
  ASSERT_EQ(::poll(&closed, 1, 20000), 1) << "the reader is still there";
  EXPECT_EQ(::read(ends[0], &byte, 1), 0);
  ::close(ends[0]);
}

void expect_too_long(const ChildError& error) {
  EXPECT_EQ(error.failure, ChildFailure::kTooLong);
  EXPECT_TRUE(has(error, "does not terminate")) << error.what();
}

TEST(CadChild, EndsOneThatTakesTooLong) {
  expect_too_long(error_of([]() -> CadParts {
    std::raise(SIGXCPU);  // as the kernel does when the processor time is used up
    return {};
  }));
}

TEST(CadChild, EndsOneThatUsesUpItsSeconds) {
  expect_too_long(error_of(
      []() -> CadParts {
        while (std::clock() >= 0) {  // uses up processor time until it is stopped
        }
        return {};
      },
      {1000, 1}));
}

TEST(CadChild, EndsOneThatWaitsForEver) {
  expect_too_long(error_of(
      []() -> CadParts {
        for (;;) ::pause();  // uses no processor time
      },
      {0, 1}));
}

#ifndef __SANITIZE_ADDRESS__  // the sanitizers leave no limit on memory
#ifndef __SANITIZE_THREAD__
TEST(CadChild, RefusesMoreThanTwoGibibytes) {
  const ChildError error = error_of([]() -> CadParts {
    const auto greedy = std::make_unique<char[]>(std::size_t{5} << 29);
    return {{{std::string(1, greedy[0]), {}}}, {}, {}};
  });
  EXPECT_EQ(error.failure, ChildFailure::kTooMuchMemory);
  EXPECT_TRUE(has(error, "more data than")) << error.what();
}
#endif
#endif

}  // namespace
}  // namespace diefill::geometry
