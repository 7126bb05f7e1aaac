// Two small results of a ring, written without a run, of which commands draw pictures.
#pragma once

#include <gtest/gtest.h>

#include "process/results/fill_result.h"
#include "tests/app/program.h"
#include "tests/support/temporary_folder.h"

namespace diefill::app {

namespace fs = std::filesystem;

/// Single spheres in a ring 4 mm wide and 5 mm deep, with two instants, a tool and probes.
results::FillResult small_ring();

class EveryPicture : public ::testing::Test {
 protected:
  static void SetUpTestSuite();
  EveryPicture();
  fs::path one() const { return folder_.path() / "one"; }
  fs::path two() const { return folder_.path() / "two"; }
  fs::path out() const { return folder_.path() / "out"; }
  /// `diefill map` of the first result or of both.
  Outcome map(const std::vector<std::string>& more, bool both = false) const;

 private:
  support::TemporaryFolder folder_;
};

}  // namespace diefill::app
