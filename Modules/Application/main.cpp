#include <QApplication>
#include <cstdio>
#include <string_view>

#include "Logic/Biomechanics/BlasKernel.h"
#include "Modules/Application/Appearance.h"
#include "Modules/Application/MainWindow.h"
#include "Version.h"
#include "Widgets/Views/CaseView3D.h"

namespace {

constexpr char kHelp[] =
    "Usage: falciform-app [CASE or FILE...]\n"
    "\n"
    "Opens the window, and in it the given case folder or files: label maps (NIfTI, NRRD, MetaImage), "
    "surfaces and scans\n"
    "(VTP, VTK, STL, PLY, OBJ, XYZ, CSV), landmarks (.mrk.json, .fcsv). What a file is goes by its name; "
    "where that does\n"
    "not tell, the window asks.\n"
    "\n"
    "  -h, --help     this text\n"
    "  -v, --version  the version\n"
    "\n"
    "The command line for batch work is `falciform`.\n";

}  // namespace

int main(int argc, char** argv) {
  using namespace falciform;
  restartWithBestBlasKernel(argv);
  // Before any QApplication, which needs a display.
  for (int i = 1; i < argc; ++i) {
    const std::string_view argument = argv[i];
    if (argument == "-h" || argument == "--help") {
      std::printf("%s\n%s\n", kHelp, kResearchUse);
      return 0;
    }
    if (argument == "-v" || argument == "--version") {
      std::printf("falciform-app %s\n", kVersion);
      return 0;
    }
  }
  CaseView3D::prepareApplication();
  QApplication::setAttribute(Qt::AA_EnableHighDpiScaling);
  QApplication::setAttribute(Qt::AA_UseHighDpiPixmaps);
  QApplication application(argc, argv);  // takes Qt's own options out of the arguments
  dressApplication(application);
  const QStringList files = QApplication::arguments().mid(1);
  for (const QString& file : files)
    if (file.startsWith('-')) {
      std::fprintf(stderr, "falciform-app: unknown option %s; see falciform-app --help\n", qPrintable(file));
      return 2;
    }
  Workbench bench;
  MainWindow window(bench);
  window.show();
  window.offerRecovery();
  window.open(files);
  return QApplication::exec();
}
