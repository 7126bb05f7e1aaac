#include "process/run/checkpoint.h"

#include <array>
#include <cstring>
#include <fstream>
#include <sstream>
#include <type_traits>

#include "engine/numerics/fnv1a.h"
#include "process/results/storage/atomic_file.h"
#include "process/results/storage/result_file.h"

namespace diefill::process {

namespace {

constexpr std::array<char, 8> kMagic = {'d', 'f', 'c', 'h', 'k', 'p', '1', '7'};

std::uint64_t hash_of(const std::string& bytes) {
  engine::Fnv1a hash;
  hash.add(bytes);
  return hash.value();
}

/// Appends values to a string of bytes.
class Writer {
 public:
  template <class Value>
  void operator()(const Value& value) {
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  template <class Value>
  void operator()(const std::vector<Value>& values) {
    (*this)(static_cast<std::uint64_t>(values.size()));
    bytes_.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(Value));
  }
  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

/// Takes the same values back in the same order.
class Reader {
 public:
  explicit Reader(std::string bytes) : bytes_(std::move(bytes)) {}
  template <class Value>
  void operator()(Value& value) {
    take(&value, sizeof value);
  }
  template <class Value>
  void operator()(std::vector<Value>& values) {
    std::uint64_t count = 0;
    (*this)(count);
    if (count > (bytes_.size() - at_) / sizeof(Value)) throw results::ResultError("it is damaged");
    values.resize(count);
    take(values.data(), count * sizeof(Value));
  }

 private:
  void take(void* target, std::size_t size) {
    if (bytes_.size() - at_ < size) throw results::ResultError("it is truncated");
    if (size > 0) std::memcpy(target, bytes_.data() + at_, size);
    at_ += size;
  }
  std::string bytes_;
  std::size_t at_ = 0;
};

template <class Io, class Instants>
void transfer_instants(Io& io, Instants& instants) {
  std::uint64_t count = instants.size();
  io(count);
  if constexpr (!std::is_const_v<Instants>) instants.resize(count);
  for (auto& instant : instants) {
    io(instant.time);
    io(instant.id);
    io(instant.kind);
    io(instant.position);
    io(instant.orientation);
    io(instant.velocity);
    io(instant.tool_orientation);
    io(instant.tool_displacement);
  }
}

/// Passes every value of a checkpoint to `io`, a Writer or a Reader: one list, so that the two cannot differ.
template <class Io, class Contents>
void transfer(Io& io, Contents& checkpoint) {
  io(checkpoint.scene_hash);
  io(checkpoint.start_hash);
  io(checkpoint.grains_left);
  io(checkpoint.grains_sheared);
  io(checkpoint.grains_leaked);
  io(checkpoint.wall_seconds);
  io(checkpoint.sphere_steps);
  io(checkpoint.schedule.steps);
  io(checkpoint.schedule.loads);
  io(checkpoint.schedule.loads_summed);
  io(checkpoint.schedule.last_update);
  io(checkpoint.probes.probes);
  io(checkpoint.probes.rows);
  io(checkpoint.free_tools.bodies);
  io(checkpoint.free_tools.numbers);
  io(checkpoint.free_tools.rows);
  io(checkpoint.snapshots);
  auto& simulation = checkpoint.simulation;
  io(simulation.step);
  io(simulation.time);
  auto& grains = simulation.grains;
  io(grains.id);
  io(grains.kind);
  io(grains.position);
  io(grains.velocity);
  io(grains.orientation);
  io(grains.spin);
  io(grains.force);
  io(grains.torque);
  io(simulation.reference.position);
  io(simulation.reference.orientation);
  io(simulation.reference.bodies);
  io(simulation.reference.drift);
  io(simulation.reference.time);
  io(simulation.reference.step);
  io(simulation.reference.skin);
  io(simulation.reference.doublings);
  io(simulation.reference.body_allowance);
  io(simulation.reference.awake_grains);
  io(simulation.grain_history.pair);
  io(simulation.grain_history.value);
  io(simulation.wall_history.pair);
  io(simulation.wall_history.value);
  io(simulation.ledger);
  io(simulation.next_id);
  io(simulation.overlap);
  io(simulation.sleep.asleep);
  io(simulation.sleep.looks);
  io(simulation.sleep.force);
  io(simulation.sleep.place);
  io(simulation.sleep.sphere_steps_left_out);
  transfer_instants(io, checkpoint.instants);
}

}  // namespace

std::filesystem::path checkpoint_file(const std::filesystem::path& directory) {
  return directory / "checkpoint.bin";
}

void write_checkpoint(const std::filesystem::path& path, const Checkpoint& checkpoint) {
  Writer contents;
  transfer(contents, checkpoint);
  results::write_atomically(path, [&](const std::filesystem::path& temporary) {
    std::ofstream file(temporary, std::ios::binary);
    const std::uint64_t hash = hash_of(contents.bytes());
    file.write(kMagic.data(), kMagic.size());
    file.write(reinterpret_cast<const char*>(&hash), sizeof hash);
    file.write(contents.bytes().data(), static_cast<std::streamsize>(contents.bytes().size()));
    file.close();
    if (!file) throw results::ResultError(temporary.string() + ": cannot be written; is the disk full?");
  });
}

std::optional<Checkpoint> read_checkpoint(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return std::nullopt;
  std::ostringstream text;
  text << file.rdbuf();
  const std::string all = text.str();
  const auto refuse = [&](const std::string& why) {
    return results::ResultError(path.string() + ": cannot resume from this checkpoint: " + why +
                                "; delete it or run without --resume");
  };
  std::uint64_t hash = 0;
  const std::size_t header = kMagic.size() + sizeof hash;
  if (all.size() < header || std::memcmp(all.data(), kMagic.data(), kMagic.size()) != 0)
    throw refuse("it is not a checkpoint of this program version");
  std::memcpy(&hash, all.data() + kMagic.size(), sizeof hash);
  const std::string contents = all.substr(header);
  if (hash_of(contents) != hash) throw refuse("its contents are damaged");
  Checkpoint checkpoint;
  try {
    Reader reader(contents);
    transfer(reader, checkpoint);
  } catch (const results::ResultError& error) {
    throw refuse(error.what());
  }
  return checkpoint;
}

}  // namespace diefill::process
