// The child process that reads CAD: results come through whole, crashes and greed end as one reason.
#include "geometry/cad/cad_child.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <ctime>
#include <memory>
#include <stdexcept>

#include "tests/geometry/sample_meshes.h"

namespace diefill::geometry {
namespace {

std::string reason_of(const std::function<CadParts()>& read) {
  try {
    read_in_child(read, {1000, 60});
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
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
  EXPECT_EQ(reason_of([]() -> CadParts { throw std::runtime_error("it contains no surface"); }),
            "it contains no surface");
}

TEST(CadChild, SurvivesACrash) {
  for (const int fatal : {SIGSEGV, SIGABRT, SIGFPE}) {
    const std::string reason = reason_of([&]() -> CadParts {
      std::raise(fatal);
      return {};
    });
    EXPECT_NE(reason.find("importer crashed"), std::string::npos) << reason;
  }
}

TEST(CadChild, EndsOneThatTakesTooLong) {
  const std::string reason = reason_of([]() -> CadParts {
    std::raise(SIGXCPU);  // as the kernel does when the processor time is used up
    return {};
  });
  EXPECT_NE(reason.find("does not terminate"), std::string::npos) << reason;
}

TEST(CadChild, EndsOneThatUsesUpItsSeconds) {
  std::string reason;
  try {
    read_in_child(
        []() -> CadParts {
          while (std::clock() >= 0) {  // uses up processor time until it is stopped
          }
          return {};
        },
        {1000, 1});
  } catch (const std::runtime_error& error) {
    reason = error.what();
  }
  EXPECT_NE(reason.find("does not terminate"), std::string::npos) << reason;
}

TEST(CadChild, EndsOneThatWaitsForEver) {
  std::string reason;
  try {
    read_in_child(
        []() -> CadParts {
          for (;;) ::pause();  // uses no processor time
        },
        {0, 1});
  } catch (const std::runtime_error& error) {
    reason = error.what();
  }
  EXPECT_NE(reason.find("does not terminate"), std::string::npos) << reason;
}

#ifndef __SANITIZE_ADDRESS__  // the sanitizers leave no limit on memory
#ifndef __SANITIZE_THREAD__
TEST(CadChild, RefusesMoreThanTwoGibibytes) {
  const std::string reason = reason_of([]() -> CadParts {
    const auto greedy = std::make_unique<char[]>(std::size_t{5} << 29);
    return {{{std::string(1, greedy[0]), {}}}, {}, {}};
  });
  EXPECT_NE(reason.find("more data than"), std::string::npos) << reason;
}
#endif
#endif

}  // namespace
}  // namespace diefill::geometry
