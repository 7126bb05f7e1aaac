#include "process/cluster/lammps/lammps_engine.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <thread>

#include "process/cluster/lammps/grain_messages.h"

namespace diefill::process::cluster {

namespace {

enum class Order : int { load, run, grains, contacts, stop };

/// What rank 0 asks all ranks for.
struct Task {
  Order order = Order::stop;
  std::uint64_t steps = 0;
};

/// The task that rank 0 gives. Other ranks wait for it without using up their cores.
Task task_of(Task given, const RankEngine& ranks) {
  std::uint64_t numbers[2] = {static_cast<std::uint64_t>(given.order), given.steps};
  MPI_Request request;
  MPI_Ibcast(numbers, 2, MPI_UINT64_T, 0, ranks.communicator(), &request);
  constexpr int kSpins = 2000;
  int done = 0;
  for (int tries = 0; done == 0; ++tries) {
    MPI_Test(&request, &done, MPI_STATUS_IGNORE);
    if (done == 0 && tries > kSpins) std::this_thread::sleep_for(std::chrono::microseconds(100));
  }
  return {static_cast<Order>(numbers[0]), numbers[1]};
}

/// Does `work`, in which all ranks take part. If it fails on this rank, the others would wait for it forever:
/// the program ends, with a one-line message.
template <class Work>
auto with_all(const RankEngine& ranks, const Work& work) {
  try {
    return work();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "diefill: %s\n", error.what());
    std::fflush(stderr);
    MPI_Abort(ranks.communicator(), 1);
    throw;
  }
}

}  // namespace

LammpsEngine::~LammpsEngine() {
  task_of({Order::stop, 0}, ranks_);
}

void LammpsEngine::step(engine::Simulation& simulation, std::uint64_t sync_step) {
  if (computed_.empty()) compute(simulation, std::max<std::uint64_t>(1, sync_step - simulation.steps()));
  simulation.apply_computed_step(computed_.front());
  computed_.pop_front();
  grains_synced_ = contacts_synced_ = false;
}

void LammpsEngine::compute(engine::Simulation& simulation, std::uint64_t steps) {
  if (simulation.searches() != searches_) {
    if (!contacts_synced_)
      throw std::logic_error("the simulation was changed before its contacts were synchronised");
    task_of({Order::load, 0}, ranks_);
    with_all(ranks_, [&] {
      ranks_.load(&simulation);
      shares_ = ranks_.shares();
    });
    searches_ = simulation.searches();
  }
  std::vector<engine::BodyMotion> motions;
  const double time_step = simulation.settings().time_step;
  for (std::uint64_t k = 1; k <= steps; ++k)
    for (const auto& body : simulation.bodies())
      motions.push_back(body.motion_at(static_cast<double>(simulation.steps() + k) * time_step));
  task_of({Order::run, steps}, ranks_);
  const StepRecords records = with_all(ranks_, [&] { return ranks_.run(steps, motions); });
  for (std::uint64_t k = 0; k < steps; ++k) computed_.push_back(records.step(k, simulation.bodies().size()));
}

void LammpsEngine::sync_grains(engine::Simulation& simulation) {
  if (grains_synced_) return;
  task_of({Order::grains, 0}, ranks_);
  simulation.apply_computed_grains(with_all(ranks_, [&] { return ranks_.grains(); }));
  grains_synced_ = true;
}

void LammpsEngine::sync_contacts(engine::Simulation& simulation) {
  if (contacts_synced_) return;
  task_of({Order::contacts, 0}, ranks_);
  engine::Grains grains;
  engine::NamedContacts of_grains, of_walls;
  with_all(ranks_, [&] {
    grains = ranks_.grains();
    of_grains = ranks_.contacts_of_grains();
    of_walls = ranks_.contacts_of_walls();
    shares_ = ranks_.shares();
  });
  const auto& settings = simulation.neighbours().settings();
  of_grains.history = with_width(of_grains, settings.grain_history_sign.size());
  of_walls.history = with_width(of_walls, settings.wall_history);
  simulation.apply_computed_grains(grains, of_grains, of_walls);
  searches_ = simulation.searches();
  grains_synced_ = contacts_synced_ = true;
}

void LammpsEngine::forget() {
  searches_ = ~std::uint64_t{0};
  computed_.clear();
  grains_synced_ = contacts_synced_ = true;
}

std::string LammpsEngine::description() const {
  std::string text = "computed by LAMMPS " + ranks_.release() + " on " + std::to_string(ranks_.ranks()) +
                     (ranks_.ranks() == 1 ? " rank" : " ranks, grains shared by recursive bisection");
  if (shares_.size() > 1) {
    text += ", now ";
    for (std::size_t k = 0; k < shares_.size(); ++k)
      text += (k == 0 ? "" : " + ") + std::to_string(shares_[k]);
  }
  return text + "; the state depends on the number of ranks, as rounding does";
}

void serve(RankEngine& ranks) {
  for (;;) {
    const Task task = task_of({}, ranks);
    if (task.order == Order::stop) return;
    if (task.order == Order::load) {
      ranks.load(nullptr);
      ranks.shares();
    } else if (task.order == Order::run) {
      ranks.run(task.steps, {});
    } else if (task.order == Order::grains) {
      ranks.grains();
    } else {
      ranks.grains();
      ranks.contacts_of_grains();
      ranks.contacts_of_walls();
      ranks.shares();
    }
  }
}

}  // namespace diefill::process::cluster
