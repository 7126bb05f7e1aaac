#include "process/results/storage/atomic_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstring>
#include <optional>
#include <regex>
#include <string>
#include <vector>

#include "process/results/storage/result_file.h"

namespace diefill::results {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& target, const std::string& reason) {
  throw ResultError("cannot write " + target.string() + ": " + reason +
                    "; nothing was changed: free some space or choose another directory, then try again");
}

[[noreturn]] void fail_with_errno(const fs::path& target) {
  fail(target, std::strerror(errno));
}

/// A file descriptor that closes itself.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int number() const { return number_; }
  bool valid() const { return number_ >= 0; }
  /// Closes now; false where the system reports that data was lost.
  bool close() {
    const int closing = number_;
    number_ = -1;
    return ::close(closing) == 0;
  }

 private:
  int number_;
};

/// A file beside the target that no other process uses; removed with this object unless it was renamed to the
/// target.
class TemporaryFile {
 public:
  explicit TemporaryFile(const fs::path& target) {
    static std::atomic<unsigned> counter{0};
    for (int attempt = 0; attempt < 1000; ++attempt) {
      std::string suffix(".diefill-");
      suffix.append(std::to_string(::getpid())).append("-").append(std::to_string(counter++)).append(".tmp");
      path_ = target;
      path_ += suffix;
      Descriptor file(::open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
      if (file.valid()) return;
      if (errno != EEXIST) fail_with_errno(target);
    }
    fail(target, "no free name for a temporary file");
  }
  ~TemporaryFile() {
    if (!path_.empty()) ::unlink(path_.c_str());
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  const fs::path& path() const { return path_; }

  void become(const fs::path& target) {
    if (::rename(path_.c_str(), target.c_str()) != 0) fail_with_errno(target);
    path_.clear();
  }

 private:
  fs::path path_;
};

void flush_to_disk(const fs::path& path, int flags, const fs::path& target) {
  Descriptor file(::open(path.c_str(), flags | O_CLOEXEC));
  if (!file.valid() || ::fsync(file.number()) != 0 || !file.close()) fail_with_errno(target);
}

/// Makes the rename last. The new file is already in place and whole, so file systems that cannot flush a
/// directory (some network mounts) are no reason to call the write a failure.
void flush_directory(const fs::path& directory) {
  Descriptor handle(::open(directory.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (handle.valid()) ::fsync(handle.number());
}

/// The process that owns a temporary file, by the file's name: `<target>.diefill-<process>-<number>.tmp`, or
/// of results without that word, as earlier versions called them; nothing for other files, which may be
/// anyone's.
std::optional<pid_t> writer_of(const std::string& name) {
  static const std::regex temporary(
      R"((?:.+\.diefill-|(?:results\.h5|results\.xdmf|report\.json|checkpoint\.bin)\.)([0-9]{1,9})-[0-9]+\.tmp)");
  std::smatch parts;
  if (!std::regex_match(name, parts, temporary)) return std::nullopt;
  return static_cast<pid_t>(std::stol(parts[1]));
}

/// Whether the process with this id runs this program; ids are reused. A process that may not be inspected
/// counts as running.
bool is_at_work(pid_t process) {
  if (process == ::getpid()) return false;  // this process has just begun
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/" + std::to_string(process) + "/exe", error);
  if (error) return error != std::errc::no_such_file_or_directory;
  return program.filename() == fs::read_symlink("/proc/self/exe", error).filename();
}

void write_all(const fs::path& path, std::string_view text) {
  Descriptor file(::open(path.c_str(), O_WRONLY | O_TRUNC | O_CLOEXEC));
  if (!file.valid()) throw ResultError(std::strerror(errno));
  while (!text.empty()) {
    const ssize_t written = ::write(file.number(), text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) throw ResultError(std::strerror(errno));
    text.remove_prefix(static_cast<std::size_t>(written));
  }
  if (!file.close()) throw ResultError(std::strerror(errno));
}

}  // namespace

void write_atomically(const fs::path& target, const std::function<void(const fs::path&)>& write) {
  TemporaryFile temporary(target);
  try {
    write(temporary.path());
  } catch (const std::exception& error) {
    fail(target, error.what());
  }
  flush_to_disk(temporary.path(), O_RDONLY, target);
  temporary.become(target);
  flush_directory(target.has_parent_path() ? target.parent_path() : fs::path("."));
}

void write_text_atomically(const fs::path& target, std::string_view text) {
  write_atomically(target, [text](const fs::path& path) { write_all(path, text); });
}

void remove_abandoned_files(const fs::path& directory) {
  std::error_code ignored;
  std::vector<fs::path> abandoned;
  for (const auto& entry : fs::directory_iterator(directory, ignored)) {
    const auto writer = writer_of(entry.path().filename().string());
    if (writer && entry.is_regular_file(ignored) && !is_at_work(*writer)) abandoned.push_back(entry.path());
  }
  for (const fs::path& file : abandoned) fs::remove(file, ignored);
}

}  // namespace diefill::results
