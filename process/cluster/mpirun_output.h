// Separates the messages of ranks from those of mpirun and ssh on the same stream, and condenses the latter
// into one line.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace diefill::process::cluster {

/// Rank 0 prints this line once all ranks have started, where the environment variable kAnnounceRanks is set.
inline constexpr std::string_view kRanksBegin = "diefill-mpi: ranks begin";
inline constexpr const char* kAnnounceRanks = "DIEFILL_SAY_BEGIN";

/// Takes standard error of mpirun line by line.
class MpirunOutput {
 public:
  /// True where the line is the program's and is to be shown.
  bool is_of_program(const std::string& line);
  /// Whether all ranks have started.
  bool begun() const { return begun_; }
  /// Whether the program has reported why it failed.
  bool reported_error() const { return reported_error_; }
  /// Why mpirun failed, as reported by it or ssh, one line without a full stop; empty where they reported
  /// nothing.
  std::string reason() const;

 private:
  bool begun_ = false, reported_error_ = false, in_block_ = false, paragraph_over_ = false;
  std::vector<std::string> blocks_;  ///< first paragraphs of what mpirun puts between rulers
  std::string last_word_;            ///< outside of them, before ranks began: ssh or the loader of programs
};

}  // namespace diefill::process::cluster
