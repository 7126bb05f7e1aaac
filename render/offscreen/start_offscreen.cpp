#include "render/offscreen/start_offscreen.h"

#include <vtkSmartPointer.h>

#include <QFontDatabase>
#include <QGuiApplication>
#include <QLoggingCategory>
#include <clocale>
#include <stdexcept>

#include "render/offscreen/offscreen.h"

namespace diefill::render {

void start_offscreen(int& argc, char** argv) {
  if (!QCoreApplication::instance()) {
    if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "offscreen");
    // Qt keeps these for as long as it lives, and takes options it knows out of them: it gets the program's
    // name only.
    static char nameless[] = "diefill";
    static int count = 1;
    static char* arguments[] = {argc > 0 ? argv[0] : nameless, nullptr};
    // Qt remarks on missing session folders, which pictures do not need.
    QLoggingCategory::setFilterRules(QStringLiteral("default.warning=false"));
    // Never deleted: pictures may be drawn until the very end, and the order in which static objects are
    // destroyed is undefined.
    static const auto* const application = new QGuiApplication(count, arguments);
    static_cast<void>(application);
    QLoggingCategory::setFilterRules(QString());
    std::setlocale(LC_NUMERIC, "C");  // Qt takes the user's locale; numbers in files keep their decimal point
  }
  if (QFontDatabase::families().isEmpty())
    throw std::runtime_error("no font found to label pictures with: install the package fonts-dejavu-core");
  const auto window = vtkSmartPointer<OffscreenWindow>::New();
  window->open(16, 16);
}

}  // namespace diefill::render
