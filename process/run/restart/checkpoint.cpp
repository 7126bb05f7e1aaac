#include "process/run/restart/checkpoint.h"

#include <array>
#include <cstring>
#include <fstream>

#include "engine/numerics/fnv1a.h"
#include "process/results/storage/atomic_file.h"
#include "process/results/storage/file_contents.h"
#include "process/results/storage/result_file.h"
#include "process/run/restart/state_bytes.h"

namespace diefill::process {

namespace {

constexpr std::array<char, 8> kMagic = {'d', 'f', 'c', 'h', 'k', 'p', '2', '2'};

std::uint64_t hash_of(const std::string& bytes) {
  engine::Fnv1a hash;
  hash.add(bytes);
  return hash.value();
}

/// Passes every value of the warnings to `io`, a ByteWriter or a ByteReader.
template <class Io, class Warnings>
void transfer_warnings(Io& io, Warnings& warnings) {
  io(warnings.energy);
  io(warnings.speed);
  io(warnings.contacts);
  io(warnings.texts);
}

/// Passes every value of a checkpoint to `io`, a ByteWriter or a ByteReader: one list, so that the two cannot
/// differ.
template <class Io, class Contents>
void transfer(Io& io, Contents& checkpoint) {
  io(checkpoint.scene_hash);
  io(checkpoint.start_hash);
  io(checkpoint.grains_removed);
  io(checkpoint.grains_sheared);
  io(checkpoint.leaks.grains);
  io(checkpoint.leaks.warned);
  io(checkpoint.strays.grains);
  io(checkpoint.strays.tool);
  io(checkpoint.strays.place);
  io(checkpoint.strays.time);
  io(checkpoint.standstill.rest);
  io(checkpoint.standstill.since);
  transfer_warnings(io, checkpoint.warnings);
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
  transfer_simulation(io, checkpoint.simulation);
  transfer_instants(io, checkpoint.instants);
}

}  // namespace

std::filesystem::path checkpoint_file(const std::filesystem::path& directory) {
  return directory / "checkpoint.bin";
}

void write_checkpoint(const std::filesystem::path& path, const Checkpoint& checkpoint) {
  ByteWriter contents;
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
  const auto bytes = results::contents_or_nothing(path);
  if (!bytes) return std::nullopt;
  const std::string& all = *bytes;
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
    ByteReader reader(contents);
    transfer(reader, checkpoint);
  } catch (const results::ResultError& error) {
    throw refuse(error.what());
  }
  return checkpoint;
}

}  // namespace diefill::process
