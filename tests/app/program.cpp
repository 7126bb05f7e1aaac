#include "tests/app/program.h"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <sstream>
#include <stdexcept>

#include "project_paths.h"

namespace diefill::app {

namespace {

/// A nameless file that takes in a stream of the child: unlike a pipe it never makes the child wait.
int nameless_file() {
  std::string name = (std::filesystem::temp_directory_path() / "diefill_stream_XXXXXX").string();
  const int descriptor = mkstemp(name.data());
  if (descriptor < 0) throw std::runtime_error("no file for the program's output could be made");
  ::unlink(name.c_str());
  return descriptor;
}

/// " 42 %  covering ...", which work of ten seconds prints on a busy machine.
bool is_progress(const std::string& line) {
  const std::size_t percent = line.find(" %  ");
  return percent != std::string::npos && line.find_first_not_of(" 0123456789") == percent + 1;
}

/// In the child: never returns.
[[noreturn]] void become_program(std::vector<char*> arguments, const Surroundings& surroundings, int out,
                                 int err) {
  constexpr int kCannotStart = 127;
  if (::chdir(surroundings.working_directory.c_str()) != 0) ::_exit(kCannotStart);
  ::dup2(out, STDOUT_FILENO);
  ::dup2(err, STDERR_FILENO);
  if (surroundings.largest_file) {
    std::signal(SIGXFSZ, SIG_IGN);  // so that write() fails with an error, as on a full disk
    const rlimit limit = {*surroundings.largest_file, *surroundings.largest_file};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  ::execv(arguments.front(), arguments.data());
  ::_exit(kCannotStart);
}

}  // namespace

std::size_t Outcome::complaints() const {
  std::size_t count = 0;
  std::istringstream lines(err);
  for (std::string line; std::getline(lines, line);)
    if (!is_progress(line)) ++count;
  return count;
}

Program::Program(const std::vector<std::string>& arguments, const Surroundings& surroundings)
    : out_(nameless_file()), err_(nameless_file()) {
  std::vector<std::string> words = {surroundings.program.empty() ? DIEFILL_PROGRAM
                                                                 : surroundings.program.string()};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (auto& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  process_ = ::fork();
  if (process_ < 0) throw std::runtime_error("no process for the program could be made");
  if (process_ == 0) become_program(pointers, surroundings, out_, err_);
}

Program::~Program() {
  send(SIGKILL);
  ended(0);
  ::close(out_);
  ::close(err_);
}

void Program::send(int signal) {
  if (running()) ::kill(process_, signal);
}

bool Program::running() {
  return !ended(WNOHANG);
}

bool Program::ended(int options) {
  if (over_) return true;
  pid_t answer = 0;
  do answer = ::waitpid(process_, &status_, options);
  while (answer < 0 && errno == EINTR);
  over_ = answer == process_;
  return over_;
}

std::string Program::text_of(int descriptor) const {
  std::string text;
  char part[4096];
  ssize_t length = 0;
  while ((length = ::pread(descriptor, part, sizeof part, static_cast<off_t>(text.size()))) > 0)
    text.append(part, static_cast<std::size_t>(length));
  return text;
}

Outcome Program::wait() {
  ended(0);
  Outcome outcome;
  if (WIFEXITED(status_)) outcome.exit_code = WEXITSTATUS(status_);
  if (WIFSIGNALED(status_)) outcome.signal = WTERMSIG(status_);
  outcome.out = text_of(out_);
  outcome.err = text_of(err_);
  return outcome;
}

Outcome run_program(const std::vector<std::string>& arguments, const Surroundings& surroundings) {
  return Program(arguments, surroundings).wait();
}

}  // namespace diefill::app
