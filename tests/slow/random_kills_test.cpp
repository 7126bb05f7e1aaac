// Many kills of one run; tests/app/commands/resume_test.cpp has few.
#include "tests/app/random_kills.h"

#include <gtest/gtest.h>

namespace diefill::app {
namespace {

TEST(Resume, EndsAsTheUnbrokenRunAfter25KillsAtRandomMoments) {
  expect_same_end_after_kills(25);
}

}  // namespace
}  // namespace diefill::app
