// Tells what ranks say from what mpirun and ssh say on the same stream, and makes one line of the latter.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace diefill::process::cluster {

/// Rank 0 says this line once all ranks are there, where the environment has kSayBegin.
inline constexpr std::string_view kRanksBegin = "diefill-mpi: ranks begin";
inline constexpr const char* kSayBegin = "DIEFILL_SAY_BEGIN";

/// Takes standard error of mpirun line by line.
class MpirunTalk {
 public:
  /// True where the line is the program's and is to be shown.
  bool is_of_program(const std::string& line);
  /// Whether all ranks have been there.
  bool begun() const { return begun_; }
  /// Whether the program has said why it failed.
  bool complained() const { return complained_; }
  /// Why mpirun failed as far as it or ssh have told, one line without a full stop; empty where they said
  /// nothing.
  std::string reason() const;

 private:
  bool begun_ = false, complained_ = false, in_block_ = false, paragraph_over_ = false;
  std::vector<std::string> blocks_;  ///< first paragraphs of what mpirun puts between rulers
  std::string last_word_;            ///< outside of them, before ranks began: ssh or the loader of programs
};

}  // namespace diefill::process::cluster
