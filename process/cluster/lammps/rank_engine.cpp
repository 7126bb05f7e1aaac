#include "process/cluster/lammps/rank_engine.h"

#include <array>
#include <cstdio>
#include <cstring>

#include "process/cluster/lammps/fix_grains.h"
#include "process/cluster/lammps/grain_messages.h"

namespace diefill::process::cluster {

namespace {

constexpr int kRelease = 20210929;  // virtual functions are called by their place in this release

/// Passes LAMMPS' errors on as lines of the program; its other output is dropped. LAMMPS ends the process
/// after an error.
ssize_t pass_errors_on(void*, const char* text, std::size_t size) {
  const std::string words(text, size);
  const std::size_t at = words.find("ERROR");
  if (at != std::string::npos)
    std::fprintf(stderr, "diefill: LAMMPS: %s\n", words.substr(at, words.find('\n', at) - at).c_str());
  return static_cast<ssize_t>(size);
}

std::FILE* error_stream() {
  cookie_io_functions_t functions = {};
  functions.write = pass_errors_on;
  std::FILE* stream = fopencookie(nullptr, "w", functions);
  if (stream != nullptr) setvbuf(stream, nullptr, _IOLBF, BUFSIZ);
  return stream;
}

/// Appends `part` to `all`.
void append(engine::Grains& all, const engine::Grains& part) {
  const auto add = [](auto& to, const auto& from) { to.insert(to.end(), from.begin(), from.end()); };
  add(all.id, part.id);
  add(all.kind, part.kind);
  add(all.position, part.position);
  add(all.velocity, part.velocity);
  add(all.orientation, part.orientation);
  add(all.spin, part.spin);
  add(all.force, part.force);
  add(all.torque, part.torque);
}

}  // namespace

RankEngine::RankEngine(MPI_Comm ranks) : communicator_(ranks) {
  MPI_Comm_size(ranks, &count_);
  MPI_Comm_rank(ranks, &rank_);
  std::array<std::string, 6> words = {"diefill", "-log", "none", "-screen", "none", "-nocite"};
  std::array<char*, 6> arguments{};
  for (std::size_t k = 0; k < words.size(); ++k) arguments[k] = words[k].data();
  lammps_ = std::make_unique<LAMMPS_NS::LAMMPS>(static_cast<int>(arguments.size()), arguments.data(), ranks);
  if (lammps_->num_ver != kRelease)
    throw OtherRelease("LAMMPS of release " + std::to_string(lammps_->num_ver) +
                       " is installed, but runs on ranks need release " + std::to_string(kRelease) +
                       " (Debian 12: liblammps0)");
  lammps_->screen = error_stream();  // of all ranks: LAMMPS has errors of single ones
}

RankEngine::~RankEngine() = default;

std::string RankEngine::release() const {
  return std::to_string(lammps_->num_ver);
}

void RankEngine::command(const std::string& words) {
  lammps_->input->one(words);
}

Packet RankEngine::broadcast(const Packet& packet) const {
  constexpr std::size_t kPiece = 1U << 30U;
  std::vector<char> bytes = packet.bytes();
  std::uint64_t size = bytes.size();
  MPI_Bcast(&size, 1, MPI_UINT64_T, 0, communicator_);
  bytes.resize(size);
  for (std::size_t at = 0; at < size; at += kPiece)
    MPI_Bcast(bytes.data() + at, static_cast<int>(std::min(kPiece, size - at)), MPI_CHAR, 0, communicator_);
  return Packet(std::move(bytes));
}

std::vector<Packet> RankEngine::gather(const Packet& packet) const {
  constexpr std::size_t kPiece = 1U << 30U;
  constexpr int kTag = 1;
  const auto& bytes = packet.bytes();
  if (rank_ != 0) {
    const std::uint64_t size = bytes.size();
    MPI_Send(&size, 1, MPI_UINT64_T, 0, kTag, communicator_);
    for (std::size_t at = 0; at < size; at += kPiece)
      MPI_Send(bytes.data() + at, static_cast<int>(std::min(kPiece, size - at)), MPI_CHAR, 0, kTag,
               communicator_);
    return {};
  }
  std::vector<Packet> packets = {packet};
  for (int from = 1; from < count_; ++from) {
    std::uint64_t size = 0;
    MPI_Recv(&size, 1, MPI_UINT64_T, from, kTag, communicator_, MPI_STATUS_IGNORE);
    std::vector<char> received(size);
    for (std::size_t at = 0; at < size; at += kPiece)
      MPI_Recv(received.data() + at, static_cast<int>(std::min(kPiece, size - at)), MPI_CHAR, from, kTag,
               communicator_, MPI_STATUS_IGNORE);
    packets.emplace_back(std::move(received));
  }
  return packets;
}

engine::Grains RankEngine::grains() {
  Packet mine;
  if (any_grains_) {
    const RankGrains& rank = FixGrains::of(*lammps_).steps().grains();
    engine::Grains own = rank.grains;
    own.resize(rank.own, rank.model.types.clumps(), !rank.model.types.monodisperse());
    put(mine, own);
  } else {
    put(mine, engine::Grains{});
  }
  engine::Grains all;
  for (Packet& packet : gather(mine)) {
    engine::Grains part;
    take(packet, part);
    append(all, part);
  }
  return all;
}

engine::NamedContacts RankEngine::gather(const engine::NamedContacts& contacts) const {
  Packet mine;
  put(mine, contacts);
  engine::NamedContacts all;
  for (Packet& packet : gather(mine)) {
    engine::NamedContacts part;
    take(packet, part);
    all.pair.insert(all.pair.end(), part.pair.begin(), part.pair.end());
    all.history.insert(all.history.end(), part.history.begin(), part.history.end());
  }
  return all;
}

engine::NamedContacts RankEngine::contacts_of_grains() {
  return gather(any_grains_ ? FixGrains::of(*lammps_).steps().contacts_of_grains() : engine::NamedContacts{});
}

engine::NamedContacts RankEngine::contacts_of_walls() {
  return gather(any_grains_ ? FixGrains::of(*lammps_).steps().contacts_of_walls() : engine::NamedContacts{});
}

std::vector<std::uint64_t> RankEngine::shares() {
  std::uint64_t own = any_grains_ ? FixGrains::of(*lammps_).steps().grains().own : 0;
  std::vector<std::uint64_t> all(static_cast<std::size_t>(count_));
  MPI_Gather(&own, 1, MPI_UINT64_T, all.data(), 1, MPI_UINT64_T, 0, communicator_);
  return all;
}

StepRecords RankEngine::run(std::size_t steps, const std::vector<engine::BodyMotion>& motions) {
  Packet message;
  put(message, motions);
  message = broadcast(message);
  std::vector<engine::BodyMotion> planned;
  take(message, planned);
  StepRecords mine, all;
  if (any_grains_) {
    RankSteps& rank = FixGrains::of(*lammps_).steps();
    rank.plan(std::move(planned));
    command("run " + std::to_string(steps) + " pre no post no");
    mine = rank.records();
  } else {
    ContactFigures none;
    none.start(bodies_);
    for (std::size_t k = 0; k < steps; ++k) mine.add(none, 0, 0, 0);
  }
  all = mine;
  MPI_Reduce(mine.sums.data(), all.sums.data(), static_cast<int>(mine.sums.size()), MPI_DOUBLE, MPI_SUM, 0,
             communicator_);
  MPI_Reduce(mine.largest.data(), all.largest.data(), static_cast<int>(mine.largest.size()), MPI_DOUBLE,
             MPI_MAX, 0, communicator_);
  return all;
}

}  // namespace diefill::process::cluster
