#include "app/commands/live_run.h"

#include <cfenv>
#include <cmath>
#include <cstdio>

#include "app/pictures/drawing.h"
#include "app/pictures/grain_colours.h"
#include "process/results/formatted.h"
#include "process/results/storage/atomic_file.h"
#include "process/results/storage/result_file.h"
#include "process/run/assemble.h"
#include "process/run/live_state.h"
#include "render/scene3d/snapshot.h"
#include "render/style/picture_bytes.h"

namespace diefill::app {
namespace {

using Seconds = std::chrono::duration<double>;

constexpr double kEvery = 5;             // s between pages
constexpr double kFirstPicture = 10;     // s after the start
constexpr double kPictureShare = 0.01;   // of the time that drawing may take
constexpr std::size_t kMaxPoints = 400;  // of a curve
constexpr int kPictureWidth = 1000;      // pixels

}  // namespace

LiveRun::LiveRun(const process::Scene& scene, const process::Tooling& tooling,
                 std::filesystem::path directory, bool pictures)
    : scene_(scene), tooling_(tooling), directory_(std::move(directory)), pictures_(pictures) {
  next_picture_ += std::chrono::duration_cast<Clock::duration>(Seconds(kFirstPicture));
  page_.title = scene.title;
  page_.curves = {{"powder in the cavity", "g", {}, {}}, {"kinetic energy of the powder", "mJ", {}, {}}};
}

void LiveRun::update(const process::FillRun& run) {
  if (given_up_ || Seconds(Clock::now() - written_).count() < kEvery) return;
  take(run);
  if (pictures_ && Clock::now() >= next_picture_) draw(run);
  write(false, "running: " + time_left());
  written_ = Clock::now();
}

void LiveRun::end(const process::FillRun& run, const std::string& how, bool done) {
  if (given_up_) return;
  take(run);
  if (done) page_.share = 1;
  write(true, how);
}

void LiveRun::take(const process::FillRun& run) {
  const process::LiveState state = process::live_state(tooling_, run);
  if (first_share_ < 0) first_share_ = state.share;
  page_.share = state.share;
  page_.margins = state.margins;
  page_.subtitle = process::powder_names(scene_) +
                   ", grains of d = " + results::formatted("%.3g mm", 1e3 * scene_.powder.grain_diameter);
  page_.facts = {
      {"Time of the scene", results::formatted("%.4f s", state.time)},
      {"Stage", state.stage},
      {"Computing time", process::duration_text(run.wall_seconds())},
      {"Model powder in the cavity", results::formatted("%.4g g", 1e3 * state.filled_mass)},
      {"Grains", std::to_string(state.grains)},
      {"Speed", results::formatted("%.2f million sphere-steps/s", 1e-6 * state.sphere_steps_per_second)}};
  const double values[] = {1e3 * state.filled_mass, 1e3 * state.kinetic_energy};
  for (std::size_t k = 0; k < page_.curves.size(); ++k) {
    page_.curves[k].x.push_back(state.time);
    page_.curves[k].y.push_back(values[k]);
  }
  thin_out();
}

/// Of every two points the later one stays.
void LiveRun::thin_out() {
  for (auto& curve : page_.curves) {
    if (curve.x.size() <= kMaxPoints) continue;
    for (auto* numbers : {&curve.x, &curve.y}) {
      for (std::size_t k = 0; 2 * k + 1 < numbers->size(); ++k) (*numbers)[k] = (*numbers)[2 * k + 1];
      numbers->resize(numbers->size() / 2);
    }
  }
}

void LiveRun::draw(const process::FillRun& run) {
  const auto start = Clock::now();
  // Drawing libraries may change the floating-point rounding mode; the run must not be affected.
  std::fenv_t floating_point;
  std::fegetenv(&floating_point);
  set_up_drawing();
  const auto shown = process::powder_and_tools(scene_, tooling_, run);
  render::ViewOptions options;
  colour_grains(options, "speed", shown, shown);
  page_.picture = render::png_bytes(render::compose_snapshot(shown, options).image, kPictureWidth);
  page_.picture_caption = "Powder and tools at t = " + results::formatted("%.4f s", run.simulation().time()) +
                          ", cut open; grains coloured by speed.";
  std::fesetenv(&floating_point);
  const Seconds pause = (Clock::now() - start) / kPictureShare;
  next_picture_ = Clock::now() + std::chrono::duration_cast<Clock::duration>(pause);
}

std::string LiveRun::time_left() const {
  const double done = page_.share - first_share_, elapsed = Seconds(Clock::now() - start_).count();
  if (!(done > 0)) return "time left not known yet";
  return process::duration_text(elapsed * (1 - page_.share) / done) + " left";
}

void LiveRun::write(bool over, const std::string& state) {
  page_.over = over;
  page_.state = state;
  try {
    results::write_text_atomically(directory_ / kLivePage, render::report::live_html(page_));
  } catch (const results::ResultError& error) {
    given_up_ = true;
    std::fprintf(stderr, "note: %s; the run goes on without it\n", error.what());
  }
}

}  // namespace diefill::app
