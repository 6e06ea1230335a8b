#include "Modules/CommandLine/UpdatePicture.h"

#include "Modules/CommandLine/UpdateTiles.h"

namespace falciform::commandline {

void saveUpdatePicture(const Surface& preop, const Surface& updated, const Surface& scan,
                       const Isometry3d& scanFromPreopRigid, const std::filesystem::path& file,
                       Overwrite overwrite) {
  const UpdateTiles tiles(preop, updated, scan, scanFromPreopRigid);
  std::vector<RenderedImage> row{tiles.registered(), tiles.moved()};
  if (tiles.expectsError()) row.push_back(tiles.expectedError());
  savePng(sheetOf(row, static_cast<int>(row.size())), file, overwrite);
}

}  // namespace falciform::commandline
