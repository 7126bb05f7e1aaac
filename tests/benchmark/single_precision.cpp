// What single precision would gain and lose: the work on touching pairs of a settled bed (distance tests,
// packing, Bierwisch's law, sums) in double and in single precision, in turns in one run, with places
// relative to the block and sums in double. The kernel is a plain one, the same lines for both, so that only
// the numbers' width differs.
//   ninja single_precision && bin/single_precision spheres|clumps BED.csv.gz [REPEATS]
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <limits>
#include <string>
#include <vector>

#include "engine/simulation/simulation.h"
#include "process/laboratory/benchmark_bed.h"

namespace diefill {
namespace {

using engine::Block;
using engine::GrainPair;

constexpr std::size_t kLanes = 64;
constexpr double kTimeStep = 2e-6, kModulus = 1e7, kFriction = 0.5;  // s, Pa

/// Three numbers of a sphere and one that pads.
template <class Number>
struct Three {
  Number x = 0, y = 0, z = 0, spare = 0;
};

/// A block's spheres as a kernel reads them, relative to the block's reference point.
template <class Number>
struct Spheres {
  std::vector<Three<Number>> place, velocity, spin;
};

/// Touching pairs side by side.
template <class Number>
struct Batch {
  alignas(64) Number x[kLanes], y[kLanes], z[kLanes];     // m, separation
  alignas(64) Number u[kLanes], v[kLanes], w[kLanes];     // m/s, difference of velocities
  alignas(64) Number p[kLanes], q[kLanes], r[kLanes];     // rad/s, sum of spins
  alignas(64) Number a[kLanes], b[kLanes], c[kLanes];     // m, spring
  alignas(64) Number fx[kLanes], fy[kLanes], fz[kLanes];  // N
  alignas(64) Number mx[kLanes], my[kLanes], mz[kLanes];  // N m
};

/// Bierwisch's law of equal spheres (2009, Eqs. 2.3, 2.6, 2.7).
template <class Number>
struct Law {
  Number radius, reach, elastic, viscous, tangential, friction, step;

  explicit Law(double sphere)
      : radius(static_cast<Number>(sphere)),
        reach(static_cast<Number>(2 * sphere)),
        elastic(static_cast<Number>(2.0 / 3 * kModulus * std::sqrt(0.5 * sphere))),
        viscous(static_cast<Number>(1e6 * sphere * std::sqrt(0.5 * sphere))),
        tangential(static_cast<Number>(1e6 * sphere / std::sqrt(0.5 * sphere))),
        friction(static_cast<Number>(kFriction)),
        step(static_cast<Number>(kTimeStep)) {}

  void react(Batch<Number>& batch) const {
    constexpr Number kHalf = 0.5, kOne = 1, kTiny = std::numeric_limits<Number>::min();
#pragma GCC ivdep
    for (std::size_t k = 0; k < kLanes; ++k) {
      const Number square = batch.x[k] * batch.x[k] + batch.y[k] * batch.y[k] + batch.z[k] * batch.z[k];
      const Number distance = std::sqrt(square), inverse = kOne / distance;
      const Number nx = inverse * batch.x[k], ny = inverse * batch.y[k], nz = inverse * batch.z[k];
      const Number overlap = std::max(reach - distance, Number{0}), root = std::sqrt(overlap);
      // The spring turns into the tangent plane and keeps its length.
      Number a = batch.a[k], b = batch.b[k], c = batch.c[k];
      const Number before = a * a + b * b + c * c, along = a * nx + b * ny + c * nz;
      a -= along * nx, b -= along * ny, c -= along * nz;
      const Number after = a * a + b * b + c * c, turn = std::sqrt(before / (after + kTiny));
      const Number arm = radius - kHalf * overlap;
      const Number u = batch.u[k] - arm * (batch.q[k] * nz - batch.r[k] * ny);
      const Number v = batch.v[k] - arm * (batch.r[k] * nx - batch.p[k] * nz);
      const Number w = batch.w[k] - arm * (batch.p[k] * ny - batch.q[k] * nx);
      const Number speed = u * nx + v * ny + w * nz;
      a = turn * a + step * (u - speed * nx);
      b = turn * b + step * (v - speed * ny);
      c = turn * c + step * (w - speed * nz);
      const Number push = elastic * overlap * root - viscous * root * speed;
      const Number stiffness = tangential * root, length = std::sqrt(a * a + b * b + c * c);
      const Number share = std::min(kOne, friction * std::abs(push) / (stiffness * length + kTiny));
      a *= share, b *= share, c *= share;
      batch.a[k] = a, batch.b[k] = b, batch.c[k] = c;
      const Number fx = push * nx - stiffness * a, fy = push * ny - stiffness * b,
                   fz = push * nz - stiffness * c;
      batch.fx[k] = fx, batch.fy[k] = fy, batch.fz[k] = fz;
      batch.mx[k] = -arm * (ny * fz - nz * fy);
      batch.my[k] = -arm * (nz * fx - nx * fz);
      batch.mz[k] = -arm * (nx * fy - ny * fx);
    }
  }
};

/// s of processor time.
struct Times {
  double distances = 0, contacts = 0, law = 0;
  double all() const { return distances + contacts; }
};

double processor_time() {
  timespec now;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

struct Sum {
  double force[4] = {}, moment[4] = {};
};

/// One block's work with numbers of one width.
template <class Number>
struct Work {
  const std::vector<GrainPair>* near = nullptr;
  Spheres<Number> spheres;
  std::vector<Three<Number>> springs;  ///< of near pairs
  std::vector<std::uint32_t> touching;
  std::vector<Sum> sums;

  void find(Number reach) {
    touching.resize(near->size() + 1);
    std::size_t count = 0;
    for (std::uint32_t p = 0; p < near->size(); ++p) {
      const auto &i = spheres.place[(*near)[p].own], &j = spheres.place[(*near)[p].other];
      const Number x = i.x - j.x, y = i.y - j.y, z = i.z - j.z;
      touching[count] = p;
      count += x * x + y * y + z * z < reach * reach ? 1 : 0;
    }
    touching.resize(count);
  }

  /// The pairs from number `first` on; the last one fills the batch up.
  void pack(std::size_t first, Batch<Number>& batch) const {
    for (std::size_t k = 0; k < kLanes; ++k) {
      const std::uint32_t p = touching[std::min(first + k, touching.size() - 1)];
      const GrainPair pair = (*near)[p];
      const auto &i = spheres.place[pair.own], &j = spheres.place[pair.other];
      batch.x[k] = i.x - j.x, batch.y[k] = i.y - j.y, batch.z[k] = i.z - j.z;
      const auto &vi = spheres.velocity[pair.own], &vj = spheres.velocity[pair.other];
      batch.u[k] = vi.x - vj.x, batch.v[k] = vi.y - vj.y, batch.w[k] = vi.z - vj.z;
      const auto &wi = spheres.spin[pair.own], &wj = spheres.spin[pair.other];
      batch.p[k] = wi.x + wj.x, batch.q[k] = wi.y + wj.y, batch.r[k] = wi.z + wj.z;
      batch.a[k] = springs[p].x, batch.b[k] = springs[p].y, batch.c[k] = springs[p].z;
    }
  }

  void add_up(std::size_t first, const Batch<Number>& batch) {
    for (std::size_t k = 0; k < kLanes && first + k < touching.size(); ++k) {
      const GrainPair pair = (*near)[touching[first + k]];
      springs[touching[first + k]] = {batch.a[k], batch.b[k], batch.c[k]};
      const double force[4] = {batch.fx[k], batch.fy[k], batch.fz[k], 0};
      const double moment[4] = {batch.mx[k], batch.my[k], batch.mz[k], 0};
      Sum &own = sums[pair.own], &other = sums[pair.other];
      for (int m = 0; m < 4; ++m) own.force[m] += force[m], own.moment[m] += moment[m];
      for (int m = 0; m < 4; ++m) other.force[m] -= force[m], other.moment[m] += moment[m];
    }
  }
};

template <class Number>
Three<Number> three(const Eigen::Vector3d& from) {
  return {static_cast<Number>(from.x()), static_cast<Number>(from.y()), static_cast<Number>(from.z())};
}

/// m/s, of sphere k of the simulation; rad/s its spin.
std::pair<Eigen::Vector3d, Eigen::Vector3d> motion_of(const engine::Simulation& simulation, std::size_t k,
                                                      const Eigen::Vector3d& place) {
  const auto& spheres = simulation.spheres();
  const std::size_t owner = spheres.owner(k);
  const Eigen::Vector3d spin = simulation.angular_velocity(owner);
  const Eigen::Vector3d centre =
      simulation.grains().position[owner] + engine::eigen(spheres.shift(k / spheres.spheres_per_grain));
  return {simulation.grains().velocity[owner] + spin.cross(place - centre), spin};
}

template <class Number>
Work<Number> work_of(const engine::Simulation& simulation, const Block& block) {
  Work<Number> work;
  work.near = &block.grain_pairs.pair;
  const std::size_t count = block.own_spheres() + block.partners.size();
  for (std::size_t local = 0; local < count; ++local) {
    const std::uint32_t k = block.sphere(static_cast<engine::LocalSphere>(local));
    const Eigen::Vector3d place = engine::eigen(simulation.spheres().position(k));
    const auto [velocity, spin] = motion_of(simulation, k, place);
    work.spheres.place.push_back(three<Number>(place - block.reference));
    work.spheres.velocity.push_back(three<Number>(velocity));
    work.spheres.spin.push_back(three<Number>(spin));
  }
  work.sums.resize(count);
  work.springs.resize(work.near->size());
  block.grain_pairs.visit_touching([&](std::size_t p, const double* spring) {
    work.springs[p] = three<Number>({spring[0], spring[1], spring[2]});
  });
  return work;
}

template <class Number>
void compute(std::vector<Work<Number>>& blocks, const Law<Number>& law, Times& times) {
  Batch<Number> batch;
  for (auto& block : blocks) {
    const double began = processor_time();
    block.find(law.reach);
    const double found = processor_time();
    std::size_t batches = 0;
    for (std::size_t first = 0; first < block.touching.size(); first += kLanes, ++batches) {
      block.pack(first, batch);
      law.react(batch);
      block.add_up(first, batch);
    }
    const double added = processor_time();
    // As many batches once more: the law without what is packed and summed.
    for (std::size_t k = 0; k < batches; ++k) law.react(batch);
    times.law += processor_time() - added;
    times.contacts += added - found;
    times.distances += found - began;
  }
}

double quantile(std::vector<double> values, double share) {
  const auto place = static_cast<std::size_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(place), values.end());
  return values[place];
}

/// What single precision loses in one step: overlaps, and forces on spheres over the weight of one.
void print_errors(const std::vector<Work<double>>& exact, const std::vector<Work<float>>& coarse,
                  double reach, double weight) {
  std::vector<double> overlaps, overlap_errors, force_errors;
  double edge = 0;  // m
  for (std::size_t b = 0; b < exact.size(); ++b) {
    for (const std::uint32_t p : exact[b].touching) {
      const GrainPair pair = (*exact[b].near)[p];
      const auto overlap = [&](const auto& work) {
        const auto &i = work.spheres.place[pair.own], &j = work.spheres.place[pair.other];
        const double x = i.x - j.x, y = i.y - j.y, z = i.z - j.z;
        return reach - std::sqrt(x * x + y * y + z * z);
      };
      overlaps.push_back(overlap(exact[b]));
      overlap_errors.push_back(std::abs(overlap(coarse[b]) - overlaps.back()) / overlaps.back());
    }
    for (const auto& place : exact[b].spheres.place)
      edge = std::max({edge, std::abs(place.x), std::abs(place.y), std::abs(place.z)});
    for (std::size_t k = 0; k < exact[b].sums.size(); ++k) {
      const double *right = exact[b].sums[k].force, *rounded = coarse[b].sums[k].force;
      force_errors.push_back(std::hypot(right[0] - rounded[0], right[1] - rounded[1], right[2] - rounded[2]) /
                             weight);
    }
  }
  std::printf("farthest from a block's reference: %.3g m, resolved there: %.2g m\n", edge,
              std::nextafter(static_cast<float>(edge), 1.0F) - static_cast<float>(edge));
  std::printf("overlaps: median %.3g m, 1 %% below %.3g m\n", quantile(overlaps, 0.5),
              quantile(overlaps, 0.01));
  std::printf("error of an overlap over itself: median %.2g, 90 %% below %.2g, 99 %% below %.2g\n",
              quantile(overlap_errors, 0.5), quantile(overlap_errors, 0.9), quantile(overlap_errors, 0.99));
  std::printf("error of a sphere's force over its weight: median %.2g, 90 %% below %.2g, 99 %% below %.2g\n",
              quantile(force_errors, 0.5), quantile(force_errors, 0.9), quantile(force_errors, 0.99));
}

/// ns of processor time of the program's own step, per sphere.
double own_step(engine::Simulation& simulation, double spheres, int steps) {
  const double began = processor_time();
  for (int k = 0; k < steps; ++k) simulation.step();
  return 1e9 * (processor_time() - began) / (spheres * steps);
}

void race(process::laboratory::BenchmarkBed kind, const std::string& file, int repeats) {
  const auto bed = process::laboratory::read_benchmark_bed(kind, file);
  engine::Simulation simulation(bed.settings, bed.walls);
  simulation.add_grains(bed.grains);
  for (int k = 0; k < 100; ++k) simulation.step();
  const auto spheres = static_cast<double>(simulation.grains().size() * simulation.types().spheres());
  const double radius = simulation.shape_of(0).sphere_radius;
  const Law<double> law(radius);
  const Law<float> narrow_law(radius);
  const auto blocks_of = [&]<class Number>(Number) {
    std::vector<Work<Number>> all;
    for (const Block& block : simulation.neighbours().blocks())
      all.push_back(work_of<Number>(simulation, block));
    return all;
  };
  auto wide = blocks_of(0.0);
  auto narrow = blocks_of(0.0F);
  Times ignored;
  compute(wide, law, ignored);
  compute(narrow, narrow_law, ignored);
  const double weight =
      9.81 * simulation.shape_of(0).mass / static_cast<double>(simulation.types().spheres());
  print_errors(wide, narrow, 2 * radius, weight);
  std::puts("repeat,precision,distances_ns,contacts_ns,law_ns_of_these,own_step_ns");
  // The lists above belong to the blocks, which a search would change: steps are timed on another.
  engine::Simulation other(bed.settings, bed.walls);
  other.add_grains(bed.grains);
  own_step(other, spheres, 100);
  std::vector<double> gains, law_gains;
  constexpr int kRounds = 40;
  for (int repeat = 1; repeat <= repeats; ++repeat) {
    Times of_wide, of_narrow;
    for (int round = 0; round < kRounds; ++round) compute(wide, law, of_wide);
    for (int round = 0; round < kRounds; ++round) compute(narrow, narrow_law, of_narrow);
    const double step = own_step(other, spheres, kRounds);
    const auto row = [&](const char* name, const Times& times) {
      const double per = 1e9 / (spheres * kRounds);
      std::printf("%d,%s,%.2f,%.2f,%.2f,%.2f\n", repeat, name, per * times.distances, per * times.contacts,
                  per * times.law, step);
    };
    row("double", of_wide);
    row("single", of_narrow);
    gains.push_back(of_wide.all() / of_narrow.all());
    law_gains.push_back(of_wide.law / of_narrow.law);
  }
  const auto phases = other.timers().seconds();
  double all = 0;
  for (const double phase : phases) all += phase;
  const double share = phases[static_cast<std::size_t>(engine::Phase::contacts)] / all;
  const double gain = quantile(gains, 0.5);
  std::printf("median gain: law %.2f, all work on pairs %.2f\n", quantile(law_gains, 0.5), gain);
  std::printf("contacts take %.2f of a step, which would gain %.2f\n", share, 1 / (1 - share + share / gain));
}

}  // namespace
}  // namespace diefill

int main(int count, char** words) {
  using diefill::process::laboratory::BenchmarkBed;
  if (count < 3) {
    std::fputs("usage: single_precision spheres|clumps BED.csv.gz [REPEATS]\n", stderr);
    return 2;
  }
  const bool clumps = std::string(words[1]) == "clumps";
  diefill::race(clumps ? BenchmarkBed::clumps : BenchmarkBed::spheres, words[2],
                count > 3 ? std::atoi(words[3]) : 7);
}
