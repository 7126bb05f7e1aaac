// Pages about running work: they reload themselves every few seconds, need no server and no script.
#pragma once

#include <QByteArray>
#include <string>
#include <vector>

#include "process/results/margins.h"

namespace diefill::render::report {

/// A curve over time; `y` in `unit`.
struct LiveCurve {
  std::string name, unit;
  std::vector<double> x, y;  ///< x: s
};

/// Content of a page about one run, or several.
struct LivePage {
  std::string title, subtitle;
  bool over = false;  ///< the page then stays as it is
  std::string state;  ///< one line, such as "running", "done" or why it has stopped
  double share = 0;   ///< of the work that is done, 0 to 1
  std::vector<std::pair<std::string, std::string>> facts;  ///< name and value
  std::vector<LiveCurve> curves;
  std::vector<results::Margin> margins;
  QByteArray picture;  ///< PNG; empty: none
  std::string picture_caption;
  std::vector<std::string> header;             ///< of the table of runs; empty: none
  std::vector<std::vector<std::string>> rows;  ///< its first cell links to `links` where that is not empty
  std::vector<std::string> links;              ///< one per row, relative to the page
};

/// s between two reloads by the browser.
inline constexpr int kLiveRefresh = 5;

/// The whole page.
std::string live_html(const LivePage& page);

}  // namespace diefill::render::report
