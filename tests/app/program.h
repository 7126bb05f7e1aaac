// Runs the real program as a child process, as a user would, and takes down how it ends and what it says.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace diefill::app {

/// How a run of the program ended.
struct Outcome {
  int exit_code = -1;  ///< -1: ended by a signal
  int signal = 0;      ///< that ended it; 0: it ended by itself
  std::string out, err;

  /// Lines on standard error other than progress.
  std::size_t complaints() const;
};

/// Surroundings of the child.
struct Surroundings {
  std::filesystem::path working_directory = std::filesystem::temp_directory_path();
  /// Bytes that a file may grow to, as on a full disk: writing beyond fails as it does there.
  std::optional<std::size_t> largest_file = std::nullopt;
  std::filesystem::path program = {};  ///< a copy of it elsewhere; empty: the one that was built
};

/// The program under way. Killed at the end of its life if it still runs.
class Program {
 public:
  explicit Program(const std::vector<std::string>& arguments, const Surroundings& surroundings = {});
  ~Program();
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  /// Sends a signal; does nothing once the program has ended.
  void send(int signal);
  bool running();
  /// Waits for the end.
  Outcome wait();

 private:
  bool ended(int options);
  std::string text_of(int descriptor) const;

  pid_t process_ = -1;
  int out_ = -1, err_ = -1, status_ = 0;
  bool over_ = false;
};

/// Runs the program to its end.
Outcome run_program(const std::vector<std::string>& arguments, const Surroundings& surroundings = {});

}  // namespace diefill::app
