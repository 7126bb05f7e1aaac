// What a contact costs by the laws of the sources: their parts acting on many contacts at a time, against one
// contact after the other, and on contacts of one law against those of many.
#include <benchmark/benchmark.h>

#include <memory>
#include <random>

#include "engine/coarse_graining/general_contact_law.h"
#include "engine/contact/contact_batch.h"
#include "tests/engine/laws/source_laws.h"

namespace diefill::engine {
namespace {

using laws::GeneralContactLaw;
using Batch = ContactBatch<GeneralContactLaw>;

constexpr double kTimeStep = 1e-7;

enum class Way { parts_of_one_law, parts_of_many_laws, one_by_one };

/// A batch of touching pairs.
std::unique_ptr<Batch> touching(const std::vector<GeneralContactLaw>& laws) {
  auto batch = std::make_unique<Batch>();
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> number(-1, 1);
  batch->count = Batch::kLanes;
  for (std::size_t lane = 0; lane < Batch::kLanes; ++lane) {
    const Vector3 way{number(random), number(random), 2};
    batch->overlap[lane] = 3e-6 + 2e-6 * number(random);
    batch->normal.set(lane, 1 / length(way) * way);
    batch->velocity.set(lane, {0.1 * number(random), 0.1 * number(random), 0.1 * number(random)});
    batch->relative_spin.set(lane, {100 * number(random), 100 * number(random), 100 * number(random)});
    for (auto& numbers : batch->history) numbers[lane] = 0;
    batch->law[lane] = &laws[lane % laws.size()];
  }
  return batch;
}

void react_one_by_one(Batch& batch) {
  for (std::size_t lane = 0; lane < Batch::kLanes; ++lane) {
    laws::ContactState state{batch.overlap[lane],       batch.normal[lane], batch.velocity[lane],
                             batch.relative_spin[lane], kTimeStep,          kTimeStep};
    batch.change_history(lane,
                         [&](double* history) { batch.put(lane, batch.law[lane]->react(state, history)); });
  }
}

void contacts(benchmark::State& state, const laws::LawParameters& law, Way way) {
  std::vector<GeneralContactLaw> laws;
  for (int k = 0; k < (way == Way::parts_of_many_laws ? 10 : 1); ++k) {
    const double radius = 2.5e-4 * (1 + 0.1 * k), mass = 1e4 * radius * radius * radius;
    laws.emplace_back(law, coarse_graining::ForceScaling{}, laws::PairProperties{radius, radius, mass, mass});
  }
  const auto batch = touching(laws);
  for (auto _ : state) {
    if (way == Way::one_by_one)
      react_one_by_one(*batch);
    else
      react_by_parts(*batch, best_instruction_set(), kTimeStep);
    benchmark::ClobberMemory();
  }
  state.counters["s_per_contact"] =
      benchmark::Counter(static_cast<double>(Batch::kLanes) * static_cast<double>(state.iterations()),
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

const int kRegistered = [] {
  for (const auto& [name, law] : laws::laws_of_the_sources())
    for (const auto& [words, way] : {std::pair{"parts, one law", Way::parts_of_one_law},
                                     {"parts, many laws", Way::parts_of_many_laws},
                                     {"one by one", Way::one_by_one}})
      benchmark::RegisterBenchmark(("contacts/" + name + "/" + words).c_str(),
                                   [=](benchmark::State& state) { contacts(state, law, way); });
  return 0;
}();

}  // namespace
}  // namespace diefill::engine
