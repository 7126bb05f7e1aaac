#include "geometry/cad/cad_child.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <new>

namespace diefill::geometry {

namespace {

constexpr std::size_t kMemory = std::size_t{2} << 30;  // bytes beyond those of this process
constexpr std::size_t kMemoryOfByte = 24;
constexpr std::size_t kBytesOfSecond = 100000;
constexpr std::size_t kWallOverProcessor = 3;  // where many programs share the machine
constexpr char kWhole = 'W';                   // first byte of an answer: parts follow
constexpr char kFailure = 'F';                 // a ChildFailure and the reader's words follow

/// Writes plain values and arrays of them into a pipe.
class Sender {
 public:
  explicit Sender(int pipe) : pipe_(pipe) {}
  void bytes(const void* data, std::size_t size) {
    const char* next = static_cast<const char*>(data);
    while (size > 0) {
      const ssize_t written = ::write(pipe_, next, size);
      if (written < 0 && errno == EINTR) continue;
      if (written <= 0) return;
      next += written;
      size -= static_cast<std::size_t>(written);
    }
  }
  template <class Value>
  void value(const Value& plain) {
    bytes(&plain, sizeof plain);
  }
  void text(const std::string& words) {
    value(words.size());
    bytes(words.data(), words.size());
  }
  void texts(const std::vector<std::string>& many) {
    value(many.size());
    for (const std::string& one : many) text(one);
  }
  template <class Value>
  void list(const std::vector<Value>& values) {
    value(values.size());
    bytes(values.data(), values.size() * sizeof(Value));
  }

 private:
  int pipe_;
};

/// The receiving end; `whole()` turns false when the child stops sending before the data are complete.
class Receiver {
 public:
  Receiver(int pipe, std::chrono::seconds most) : pipe_(pipe), end_(Clock::now() + most) {}
  bool whole() const { return whole_; }
  /// Whether the time is over and the child had sent nothing more by then.
  bool late() const { return late_; }
  void bytes(void* data, std::size_t size) {
    char* next = static_cast<char*>(data);
    while (whole_ && size > 0) {
      if (!wait_for_bytes()) return;
      const ssize_t got = ::read(pipe_, next, size);
      if (got < 0 && errno == EINTR) continue;
      whole_ = got > 0;
      if (!whole_) return;
      next += got;
      size -= static_cast<std::size_t>(got);
    }
  }
  template <class Value>
  Value value() {
    Value plain{};
    bytes(&plain, sizeof plain);
    return plain;
  }
  std::string text() {
    std::string words(whole_ ? value<std::size_t>() : 0, '\0');
    bytes(words.data(), words.size());
    return words;
  }
  std::vector<std::string> texts() {
    std::vector<std::string> many;
    for (auto left = value<std::size_t>(); whole_ && left > 0; --left) many.push_back(text());
    return many;
  }
  template <class Value>
  std::vector<Value> list() {
    std::vector<Value> values(whole_ ? value<std::size_t>() : 0);
    bytes(values.data(), values.size() * sizeof(Value));
    return values;
  }

 private:
  using Clock = std::chrono::steady_clock;

  bool wait_for_bytes() {
    for (;;) {
      const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end_ - Clock::now()).count();
      pollfd pipe{pipe_, POLLIN, 0};
      const int ready = ::poll(&pipe, 1, static_cast<int>(std::clamp<long>(left, 0, 60000)));
      if (ready > 0 || (ready < 0 && errno != EINTR)) return true;
      if (left > 0) continue;
      late_ = true;
      whole_ = false;
      return false;
    }
  }

  int pipe_;
  Clock::time_point end_;
  bool whole_ = true, late_ = false;
};

// A sanitizer's shadow memory takes terabytes of address space.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kLimitsMemory = false;
#else
constexpr bool kLimitsMemory = true;
#endif

std::size_t memory_in_use() {
  std::size_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
}

void limit(int what, rlim_t most) {
  const rlimit both{most, most};
  ::setrlimit(static_cast<__rlimit_resource>(what), &both);
}

/// Of processor time.
std::size_t seconds_of(const ChildLimits& limits) {
  return limits.seconds + limits.file_bytes / kBytesOfSecond;
}

void set_limits(const ChildLimits& limits) {
  if (kLimitsMemory) limit(RLIMIT_AS, memory_in_use() + kMemory + kMemoryOfByte * limits.file_bytes);
  limit(RLIMIT_CPU, seconds_of(limits));
  limit(RLIMIT_CORE, 0);
}

/// Libraries print messages of their own, which would break the one-line error of this program.
void silence() {
  const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
  if (nowhere < 0) return;
  ::dup2(nowhere, STDOUT_FILENO);
  ::dup2(nowhere, STDERR_FILENO);
}

void send(const CadParts& contents, Sender& sender) {
  sender.value(kWhole);
  sender.value(contents.metres_per_unit.value_or(0));
  sender.texts(contents.remarks);
  sender.value(contents.parts.size());
  for (const CadPart& part : contents.parts) {
    sender.text(part.name);
    sender.text(part.plain_name);
    sender.texts(part.assemblies);
    sender.list(part.mesh.vertices);
    sender.list(part.mesh.triangles);
  }
}

/// Whether and however the parent ends, the child ends with it. Ctrl-C in a terminal goes to both: the parent
/// decides.
void end_with(pid_t parent) {
  ::signal(SIGINT, SIG_IGN);
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(0);
}

[[noreturn]] void be_the_child(const std::function<CadParts()>& read, const ChildLimits& limits, int pipe,
                               pid_t parent) {
  for (const int fatal : {SIGSEGV, SIGABRT, SIGFPE, SIGILL, SIGBUS, SIGTERM, SIGHUP})
    ::signal(fatal, SIG_DFL);
  end_with(parent);
  silence();
  set_limits(limits);
  Sender sender(pipe);
  ChildFailure failure = ChildFailure::kRefused;
  std::string words;
  try {
    send(read(), sender);
    ::_exit(0);
  } catch (const std::bad_alloc&) {
    failure = ChildFailure::kTooMuchMemory;
  } catch (const std::exception& error) {
    words = error.what();
  } catch (...) {
    // No message: error_of() has one.
  }
  sender.value(kFailure);
  sender.value(failure);
  sender.text(words);
  ::_exit(0);
}

CadParts receive(Receiver& receiver) {
  CadParts contents;
  const auto unit = receiver.value<double>();
  if (unit > 0) contents.metres_per_unit = unit;
  contents.remarks = receiver.texts();
  const auto count = receiver.value<std::size_t>();
  for (std::size_t k = 0; receiver.whole() && k < count; ++k) {
    CadPart part{receiver.text(), {}, receiver.text(), receiver.texts()};
    part.mesh.vertices = receiver.list<Eigen::Vector3d>();
    part.mesh.triangles = receiver.list<Eigen::Vector3i>();
    contents.parts.push_back(std::move(part));
  }
  return contents;
}

/// Of a child that ended before it had answered.
ChildFailure failure_of(int status) {
  const bool stopped = WIFSIGNALED(status) && (WTERMSIG(status) == SIGXCPU || WTERMSIG(status) == SIGKILL);
  return stopped ? ChildFailure::kTooLong : ChildFailure::kCrashed;
}

/// `words`: the reader's own, if it had any.
ChildError error_of(ChildFailure failure, const std::string& words) {
  switch (failure) {
    case ChildFailure::kCrashed:
      return {failure, "the importer crashed on it, so the file must be damaged"};
    case ChildFailure::kTooLong:
      return {failure, "reading it does not terminate"};
    case ChildFailure::kTooMuchMemory:
      return {failure, "it declares more data than a file of its size can hold, so its counts must be wrong"};
    case ChildFailure::kNoChild:
    case ChildFailure::kRefused:
      break;
  }
  return {failure, words.empty() ? "the importer failed without a message" : words};
}

}  // namespace

CadParts read_in_child(const std::function<CadParts()>& read, const ChildLimits& limits) {
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) throw error_of(ChildFailure::kNoChild, "cannot open a pipe to read it");
  const pid_t parent = ::getpid(), child = ::fork();
  if (child < 0) {
    ::close(ends[0]);
    ::close(ends[1]);
    throw error_of(ChildFailure::kNoChild, "cannot start a process to read it");
  }
  if (child == 0) {
    ::close(ends[0]);
    be_the_child(read, limits, ends[1], parent);
  }
  ::close(ends[1]);
  Receiver receiver(ends[0], std::chrono::seconds(kWallOverProcessor * seconds_of(limits)));
  const char kind = receiver.value<char>();
  CadParts contents;
  ChildFailure failure = ChildFailure::kRefused;
  std::string words;
  if (kind == kWhole) contents = receive(receiver);
  if (kind == kFailure) {
    failure = receiver.value<ChildFailure>();
    words = receiver.text();
  }
  ::close(ends[0]);
  if (receiver.late()) ::kill(child, SIGKILL);
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (!receiver.whole()) throw error_of(failure_of(status), "");
  if (kind == kFailure) throw error_of(failure, words);
  return contents;
}

}  // namespace diefill::geometry
