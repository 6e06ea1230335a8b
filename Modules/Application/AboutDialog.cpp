#include "Modules/Application/AboutDialog.h"

#include <vtkVersionMacros.h>

#include <QMessageBox>
#include <QObject>

#include "Version.h"

namespace falciform {

void showAbout(QWidget* parent) {
  const QString licences = QObject::tr(
                               "<ul style='margin-left:-24px'>"
                               "<li>Qt %1: LGPL-3</li>"
                               "<li>VTK %2: BSD-3-Clause</li>"
                               "<li>Eigen: MPL-2.0</li>"
                               "<li>FLANN: BSD-2-Clause</li>"
#ifdef FALCIFORM_WITH_TETGEN
                               "<li>TetGen: AGPL-3</li>"
#endif
                               "<li>nlohmann/json: MIT</li>"
                               "<li>oneTBB, OpenSSL: Apache-2.0</li>"
                               "<li>zlib: zlib licence</li></ul>")
                               .arg(qVersion(), VTK_VERSION);
  QMessageBox box(parent);
  box.setObjectName("about");
  box.setWindowTitle(QObject::tr("About Falciform"));
  box.setTextFormat(Qt::RichText);
  box.setText(QObject::tr("<h3>Falciform %1</h3><p>Image-guided liver surgery: registration, deformation and "
                          "atlas update, after "
                          "L. W. Clements (Vanderbilt University, 2009).</p><p><b>%2</b></p>")
                  .arg(kVersion, kResearchUse));
  box.setInformativeText(
      QObject::tr("<p>The program's own licence stands in the file LICENSE. It is built from:</p>") +
      licences);
  box.exec();
}

}  // namespace falciform
